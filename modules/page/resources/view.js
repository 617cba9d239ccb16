// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// The 3D view of the page: part, stock and tool paths. What it shows is the JSON in
// #scene, which viewJson() writes; lengths in millimetres, Z up.
(function () {
  'use strict';

  const root = document.documentElement;
  const byId = (id) => document.getElementById(id);

  // ----------------------------------------------------------------- reading the scene

  function bytesOf(base64) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i)
      bytes[i] = text.charCodeAt(i);
    return bytes;
  }

  // Heights or deviations of a grid; NaN where there is none.
  function fieldOf(packed) {
    const bytes = bytesOf(packed.values);
    const values = new Float32Array(bytes.length / 2);
    for (let i = 0; i < values.length; ++i) {
      const steps = bytes[2 * i] + 256 * bytes[2 * i + 1];
      values[i] = steps === 65535 ? NaN : packed.low + steps * packed.step;
    }
    return values;
  }

  // Strokes as pairs of places, for lines: `places` and the second of each pair's end.
  function strokesOf(packed, step) {
    const bytes = bytesOf(packed);
    let at = 0;
    function number() {
      let value = 0;
      for (let unit = 1; ; unit *= 128) {
        const byte = bytes[at++];
        value += (byte & 127) * unit;
        if (byte < 128)
          return value;
      }
    }
    function signed() {
      const value = number();
      return value % 2 ? -(value + 1) / 2 : value / 2;
    }
    const places = [], seconds = [];
    const now = [0, 0, 0];
    let time = 0;
    while (at < bytes.length) {
      const count = number();
      for (let i = 0; i < count; ++i) {
        const before = now.slice();
        for (let axis = 0; axis < 3; ++axis)
          now[axis] += signed();
        time += signed();
        if (i > 0) {
          for (const p of [before, now])
            places.push(p[0] * step, p[1] * step, p[2] * step);
          seconds.push(time / 100);
        }
      }
    }
    return { places: new Float32Array(places), seconds: new Float64Array(seconds) };
  }

  // ------------------------------------------------------------------ building its parts

  // Rise per run from which a quad of a height field is a wall, with an edge.
  const STEEP = 2.5;

  // A height field through the centres of its cells. Walls have normals of their own, so
  // that edges stay crisp; the outline goes down to the floor.
  function surfaceOf(grid, heights, floor, colourAt) {
    const columns = grid.columns, rows = grid.rows, cell = grid.cell;
    const position = [], normal = [], colour = [], index = [];
    const x = (c) => grid.x + c * cell, y = (r) => grid.y + r * cell;
    const z = (c, r) =>
      c < 0 || r < 0 || c >= columns || r >= rows ? NaN : heights[r * columns + c];

    // The mean of the slopes to both sides, the gentler one at an edge.
    function slope(before, here, after) {
      const back = (here - before) / cell, ahead = (after - here) / cell;
      if (Number.isNaN(back))
        return Number.isNaN(ahead) ? 0 : ahead;
      if (Number.isNaN(ahead))
        return back;
      if (Math.abs(ahead - back) < 0.7)
        return (ahead + back) / 2;
      return Math.abs(ahead) < Math.abs(back) ? ahead : back;
    }
    function vertex(px, py, pz, n, rgb) {
      position.push(px, py, pz);
      normal.push(n[0], n[1], n[2]);
      colour.push(rgb[0], rgb[1], rgb[2]);
      return position.length / 3 - 1;
    }
    function unit(nx, ny, nz) {
      const length = Math.hypot(nx, ny, nz) || 1;
      return [nx / length, ny / length, nz / length];
    }

    const ground = new Int32Array(columns * rows).fill(-1);
    function groundVertex(c, r) {
      const i = r * columns + c;
      if (ground[i] < 0) {
        const here = heights[i];
        const gx = slope(z(c - 1, r), here, z(c + 1, r));
        const gy = slope(z(c, r - 1), here, z(c, r + 1));
        ground[i] = vertex(x(c), y(r), here, unit(-gx, -gy, 1), colourAt(i));
      }
      return ground[i];
    }

    const whole = (c, r) => c >= 0 && r >= 0 && c + 1 < columns && r + 1 < rows &&
      !Number.isNaN(z(c, r) + z(c + 1, r) + z(c, r + 1) + z(c + 1, r + 1));

    // Where the ground falls to around a quad, seen over a few cells: the staircase of the
    // cells alone would make round walls flicker.
    function fall(c, r) {
      let fx = 0, fy = 0;
      const here = z(c, r);
      for (let j = -2; j <= 3; ++j)
        for (let i = -2; i <= 3; ++i) {
          const rise = z(c + i, r + j) - here;
          if (!Number.isNaN(rise)) {
            fx -= rise * (i - 0.5);
            fy -= rise * (j - 0.5);
          }
        }
      return [fx, fy];
    }

    function quad(c, r) {
      const corners = [[c, r], [c + 1, r], [c + 1, r + 1], [c, r + 1]];
      const h = corners.map((p) => z(p[0], p[1]));
      let v;
      const steep =
        Math.hypot(h[1] + h[2] - h[0] - h[3], h[2] + h[3] - h[0] - h[1]) / (2 * cell);
      if (steep > STEEP) {
        const [fx, fy] = fall(c, r), length = Math.hypot(fx, fy) || 1;
        const n = unit(steep * fx / length, steep * fy / length, 1);
        v = corners.map((p, k) =>
          vertex(x(p[0]), y(p[1]), h[k], n, colourAt(p[1] * columns + p[0])));
      }
      else
        v = corners.map((p) => groundVertex(p[0], p[1]));
      if (Math.abs(h[0] - h[2]) <= Math.abs(h[1] - h[3]))
        index.push(v[0], v[1], v[2], v[0], v[2], v[3]);
      else
        index.push(v[0], v[1], v[3], v[1], v[2], v[3]);
    }

    // Down to the floor where a quad ends and no other goes on.
    function wall(c0, r0, c1, r1, nx, ny) {
      const n = [nx, ny, 0];
      const rgb = [0.62, 0.66, 0.7];
      const v = [vertex(x(c0), y(r0), z(c0, r0), n, rgb), vertex(x(c1), y(r1), z(c1, r1), n, rgb),
                 vertex(x(c1), y(r1), floor, n, rgb), vertex(x(c0), y(r0), floor, n, rgb)];
      index.push(v[0], v[1], v[2], v[0], v[2], v[3]);
    }

    for (let r = 0; r + 1 < rows; ++r)
      for (let c = 0; c + 1 < columns; ++c) {
        if (!whole(c, r))
          continue;
        quad(c, r);
        if (!whole(c, r - 1))
          wall(c, r, c + 1, r, 0, -1);
        if (!whole(c, r + 1))
          wall(c, r + 1, c + 1, r + 1, 0, 1);
        if (!whole(c - 1, r))
          wall(c, r, c, r + 1, -1, 0);
        if (!whole(c + 1, r))
          wall(c + 1, r, c + 1, r + 1, 1, 0);
      }

    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(position, 3));
    geometry.setAttribute('normal', new THREE.Float32BufferAttribute(normal, 3));
    geometry.setAttribute('color', new THREE.Float32BufferAttribute(colour, 3));
    geometry.setIndex(index);
    return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({
      vertexColors: THREE.VertexColors,
      side: THREE.DoubleSide,
      polygonOffset: true, // lines on it are seen
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 4
    }));
  }

  function rgbOf(text) {
    const c = new THREE.Color(text);
    return [c.r, c.g, c.b];
  }

  function linesOf(strokes, material, dashed) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(strokes.places, 3));
    const lines = new THREE.LineSegments(geometry, material);
    if (dashed && strokes.places.length > 0)
      lines.computeLineDistances();
    return lines;
  }

  function boxLines(min, max, colour) {
    const box = new THREE.BoxBufferGeometry(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
    const lines = new THREE.LineSegments(new THREE.EdgesGeometry(box),
                                         new THREE.LineBasicMaterial({ color: colour }));
    lines.position.set((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, (min[2] + max[2]) / 2);
    return lines;
  }

  function rectangleAt(min, max, z, colour, opacity) {
    const plane = new THREE.Mesh(
      new THREE.PlaneBufferGeometry(max[0] - min[0], max[1] - min[1]),
      new THREE.MeshBasicMaterial({
        color: colour, opacity: opacity, transparent: true, depthWrite: false,
        side: THREE.DoubleSide
      }));
    plane.position.set((min[0] + max[0]) / 2, (min[1] + max[1]) / 2, z);
    return plane;
  }

  function letter(text, place, size) {
    const canvas = document.createElement('canvas');
    canvas.width = canvas.height = 64;
    const pen = canvas.getContext('2d');
    pen.font = 'bold 46px sans-serif';
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.lineWidth = 9;
    pen.strokeStyle = '#ffffff';
    pen.strokeText(text, 32, 34);
    pen.fillStyle = '#1f2933';
    pen.fillText(text, 32, 34);
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({
      map: new THREE.CanvasTexture(canvas), depthTest: false
    }));
    sprite.position.set(place[0], place[1], place[2]);
    sprite.scale.set(size, size, 1);
    sprite.renderOrder = 2;
    return sprite;
  }

  // The datum: a ball with an arrow and a letter along each axis.
  function datumOf(size) {
    const group = new THREE.Group();
    const ink = 0x1f2933;
    group.add(new THREE.Mesh(new THREE.SphereBufferGeometry(size / 14, 16, 12),
                             new THREE.MeshBasicMaterial({ color: ink })));
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, i) => {
      const arrow = new THREE.ArrowHelper(new THREE.Vector3(...axis), new THREE.Vector3(),
                                          size, ink, size / 5, size / 10);
      group.add(arrow);
      group.add(letter('XYZ'[i], axis.map((a) => a * size * 1.2), size / 2.6));
    });
    return group;
  }

  function zoneOf(zone, floor) {
    const shape = new THREE.Shape();
    if (zone.radius > 0)
      shape.absarc(zone.corners[0][0], zone.corners[0][1], zone.radius, 0, 2 * Math.PI);
    else
      zone.corners.forEach((c, i) => i ? shape.lineTo(c[0], c[1]) : shape.moveTo(c[0], c[1]));
    const geometry = new THREE.ExtrudeBufferGeometry(shape, {
      depth: Math.max(zone.top - floor, 1e-3), bevelEnabled: false, curveSegments: 32
    });
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: 0xd55e00 }));
    mesh.position.z = floor;
    return mesh;
  }

  // The tool with its tip at the origin; a shank above what cuts, so that it is found.
  function toolOf(tool, length) {
    const outline = tool.outline.map((p) => new THREE.Vector2(p[0], p[1]));
    const last = outline[outline.length - 1];
    outline.push(new THREE.Vector2(last.x, Math.max(length, last.y)),
                 new THREE.Vector2(0, Math.max(length, last.y)));
    const geometry = new THREE.LatheBufferGeometry(outline, 32);
    geometry.rotateX(Math.PI / 2); // turned round Y, three.js's axis
    return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({
      color: 0x55606c, opacity: 0.75, transparent: true, side: THREE.DoubleSide
    }));
  }

  // --------------------------------------------------------------------------- controls

  function control(parent, kind, name, label, checked, onChange, swatch) {
    const element = document.createElement('label');
    const input = document.createElement('input');
    input.type = kind;
    input.name = name;
    input.checked = checked;
    input.addEventListener('change', () => onChange(input.checked));
    element.append(input);
    if (swatch) {
      const box = document.createElement('span');
      box.className = 'swatch';
      box.style.background = swatch;
      element.append(box);
    }
    element.append(document.createTextNode(label));
    parent.append(element);
    return input;
  }

  // As the page's own times: to the nearest minute.
  function clock(seconds) {
    const minutes = Math.floor(seconds / 60 + 0.5), hours = Math.floor(minutes / 60);
    if (minutes < 1)
      return seconds > 0 ? 'under 1\u00a0min' : '0\u00a0min';
    return (hours > 0 ? hours + '\u00a0h\u00a0' + String(minutes % 60).padStart(2, '0') : minutes) + '\u00a0min';
  }

  // ------------------------------------------------------------------------------ the view

  function start() {
    const scene = JSON.parse(byId('scene').textContent);
    const place = byId('view-canvas');
    const canvas = document.createElement('canvas');
    const context = canvas.getContext('webgl', { antialias: true });
    if (!context) {
      byId('view-missing').hidden = false;
      root.dataset.view = 'missing';
      return;
    }
    byId('view').hidden = false;
    place.append(canvas);

    const min = scene.min, max = scene.max;
    const size = max.map((m, i) => m - min[i]);
    const diagonal = Math.hypot(...size), axis = diagonal / 9;
    // What must be in the picture, see reach().
    const middle = new THREE.Vector3(...max.map((m, i) => (m + min[i]) / 2));
    let bounds = new THREE.Box3(new THREE.Vector3(...min), new THREE.Vector3(...max));

    const renderer = new THREE.WebGLRenderer({ canvas: canvas, context: context, antialias: true });
    renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    renderer.setClearColor(0xfbfcfd);
    const world = new THREE.Scene();
    const camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -10 * diagonal, 10 * diagonal);
    camera.up.set(0, 0, 1);
    world.add(camera);
    world.add(new THREE.HemisphereLight(0xffffff, 0xb8c0c8, 0.62));
    const sun = new THREE.DirectionalLight(0xffffff, 0.5); // over the left shoulder
    sun.position.set(-0.6, 0.9, 1);
    camera.add(sun);
    camera.add(sun.target);

    // Once for all that changes before the next picture is shown.
    let waiting = false;
    function draw() {
      if (waiting)
        return;
      waiting = true;
      window.requestAnimationFrame(() => {
        waiting = false;
        renderer.render(world, camera);
      });
    }

    const orbit = new THREE.OrbitControls(camera, canvas);
    orbit.enableKeys = false; // the page's own, they scroll
    orbit.enableZoom = false; // so does the wheel, unless the view was clicked
    orbit.screenSpacePanning = true;
    orbit.addEventListener('change', draw);
    place.addEventListener('focus', () => { orbit.enableZoom = true; });
    place.addEventListener('blur', () => { orbit.enableZoom = false; });
    canvas.addEventListener('pointerdown', () => place.focus({ preventScroll: true }));
    canvas.addEventListener('touchstart', () => { orbit.enableZoom = true; }, { capture: true, passive: true });

    // The stock with some room fills the picture from any side.
    function fit() {
      const width = Math.max(place.clientWidth, 1), height = Math.max(place.clientHeight, 1);
      renderer.setSize(width, height);
      const half = 0.56 * diagonal;
      const across = Math.max(half, half * 0.8 * width / height);
      camera.right = across;
      camera.left = -across;
      camera.top = across * height / width;
      camera.bottom = -camera.top;
      camera.updateProjectionMatrix();
      draw();
    }
    const looks = { iso: [-0.62, -1, 0.85], top: [0, -1e-4, 1], front: [0, -1, 0], right: [1, 0, 0] };
    // So far from the middle that the picture is filled, whatever side is seen.
    function zoomFor(direction) {
      camera.position.copy(middle).addScaledVector(new THREE.Vector3(...direction).normalize(), 2 * diagonal);
      camera.lookAt(middle);
      camera.updateMatrixWorld();
      const inverse = new THREE.Matrix4().getInverse(camera.matrixWorld);
      const seen = [];
      for (let i = 0; i < 8; ++i)
        seen.push(new THREE.Vector3(bounds[i & 1 ? 'max' : 'min'].x, bounds[i & 2 ? 'max' : 'min'].y,
                                    bounds[i & 4 ? 'max' : 'min'].z));
      for (let i = 0; i < 3; ++i) // the letters of the axes
        seen.push(new THREE.Vector3().setComponent(i, 1.35 * axis));
      let most = 1e-9;
      for (const corner of seen) {
        corner.applyMatrix4(inverse);
        most = Math.max(most, Math.abs(corner.x) / camera.right, Math.abs(corner.y) / camera.top);
      }
      return 0.95 / most;
    }
    const framedThings = new Map();
    let framed = null; // the zoom as it was set here
    function lookAlong(direction) {
      bounds.getCenter(middle);
      orbit.target.copy(middle);
      camera.zoom = framed = zoomFor(direction);
      camera.updateProjectionMatrix();
      orbit.update();
      draw();
    }
    function look(name) {
      lookAlong(looks[name] || looks.iso);
    }
    // Frames what is shown, unless one has moved or zoomed by hand.
    function reach() {
      const now = new THREE.Box3(new THREE.Vector3(...min), new THREE.Vector3(...max));
      framedThings.forEach((box, object) => {
        if (object.visible)
          now.union(box);
      });
      if (now.equals(bounds))
        return;
      bounds = now;
      if (camera.zoom === framed && orbit.target.distanceTo(middle) < 1e-6 * diagonal)
        lookAlong(camera.position.clone().sub(middle).toArray());
    }

    // Surfaces
    const fields = scene.fields;
    const surfaces = {};
    const heights = {};
    for (const name of ['part', 'milled'])
      if (fields[name])
        heights[name] = fieldOf(fields[name]);
    const rgbs = fields.height_colours.map(rgbOf);
    function byHeight(values) {
      let low = Infinity, high = -Infinity;
      for (const v of values)
        if (!Number.isNaN(v)) {
          low = Math.min(low, v);
          high = Math.max(high, v);
        }
      const last = rgbs.length - 1;
      return (i) => rgbs[Math.round(last * (values[i] - low) / Math.max(high - low, 1e-9))];
    }
    if (heights.milled)
      surfaces.milled = ['milled part', () => surfaceOf(fields, heights.milled, min[2], () => [0.82, 0.85, 0.88])];
    if (heights.part)
      surfaces.part = ['scan, by height', () => surfaceOf(fields, heights.part, min[2], byHeight(heights.part))];
    if (fields.deviation && heights.milled) {
      const deviation = fieldOf(fields.deviation);
      const colours = fields.deviation.colours.map(rgbOf), none = rgbOf(fields.deviation.none);
      const range = fields.deviation.range, last = colours.length - 1;
      surfaces.deviation = ['deviation from the scan', () => surfaceOf(fields, heights.milled, min[2], (i) =>
        Number.isNaN(deviation[i]) ? none
          : colours[Math.round(last * Math.min(1, Math.max(0, 0.5 + deviation[i] / range / 2)))])];
    }
    surfaces.none = ['none', () => new THREE.Group()];
    let shown = null;
    function showSurface(name) {
      if (shown)
        shown.visible = false;
      if (Array.isArray(surfaces[name])) { // made when it is wanted
        surfaces[name] = surfaces[name][1]();
        world.add(surfaces[name]);
      }
      shown = surfaces[name];
      shown.visible = true;
      byId('view-scale').hidden = name !== 'deviation';
      root.dataset.surface = name;
      draw();
    }
    const first = Object.keys(surfaces)[0];
    for (const name of Object.keys(surfaces))
      control(byId('view-surfaces'), 'radio', 'surface', surfaces[name][0], name === first, () => showSurface(name))
        .value = name;
    if (surfaces.deviation) {
      const d = fields.deviation, scale = byId('view-scale');
      const bar = document.createElement('span'), numbers = document.createElement('span');
      bar.className = 'colours';
      bar.style.background = 'linear-gradient(to right,' + d.colours.join(',') + ')';
      numbers.className = 'numbers';
      for (const text of ['\u2212' + d.range.toPrecision(2) + ' mm, too deep', '0 \u00b1 ' + d.tolerance + ' in order',
                          '+' + d.range.toPrecision(2) + ' mm, left over']) {
        const number = document.createElement('span');
        number.textContent = text;
        numbers.append(number);
      }
      const grey = document.createElement('span');
      grey.innerHTML = '<span class="swatch"></span>no tool came, or no point of the scan';
      grey.firstChild.style.background = d.none;
      scale.append(bar, numbers, grey);
    }

    // Things
    function thing(name, label, object, visible) {
      object.visible = visible;
      world.add(object);
      const input = control(byId('view-things'), 'checkbox', name, label, visible, (on) => {
        object.visible = on;
        reach();
        draw();
      });
      return input;
    }
    thing('stock', 'stock', boxLines(min, max, 0x55606c), true);
    thing('datum', 'datum and axes', datumOf(axis), true);
    const plane = rectangleAt(min, max, scene.clearance, 0x56b4e9, 0.25);
    framedThings.set(plane, new THREE.Box3().setFromObject(plane));
    thing('plane', 'clearance plane', plane, false);
    if (scene.zones.length > 0) {
      const zones = new THREE.Group();
      scene.zones.forEach((zone) => zones.add(zoneOf(zone, min[2])));
      thing('zones', 'keep-out zones', zones, true);
    }

    // Paths
    const list = scene.paths ? scene.paths.list : [];
    const paths = list.map((path) => {
      const feeds = strokesOf(path.feeds, scene.paths.step);
      const rapids = strokesOf(path.rapids, scene.paths.step);
      const parts = [
        linesOf(feeds, new THREE.LineBasicMaterial({ color: path.colour, transparent: true, opacity: 0.8 })),
        linesOf(rapids, new THREE.LineDashedMaterial({
          color: 0x1a1a1a, dashSize: diagonal / 90, gapSize: diagonal / 120 }), true)];
      parts.forEach((part, kind) => {
        world.add(part);
        const places = (kind === 0 ? feeds : rapids).places;
        if (places.length > 0)
          framedThings.set(part, new THREE.Box3().setFromArray(places));
      });
      return { path: path, on: false, strokes: [feeds, rapids], parts: parts };
    });
    let rapids = false, now = scene.paths ? scene.paths.seconds : 0;
    const tools = {};
    scene.tools.forEach((tool) => {
      tools[tool.number] = toolOf(tool, size[2] + diagonal / 6);
      tools[tool.number].visible = false;
      world.add(tools[tool.number]);
    });

    // How many of a path's moves have ended at a time.
    function endedAt(seconds, time) {
      let low = 0, high = seconds.length;
      while (low < high) {
        const half = (low + high) >> 1;
        if (seconds[half] <= time)
          low = half + 1;
        else
          high = half;
      }
      return low;
    }
    function showPaths() {
      const whole = scene.paths ? scene.paths.seconds : 0;
      let current = null, tip = null;
      for (const p of paths) {
        if (p.path.start <= now)
          current = p;
        p.parts.forEach((part, kind) => {
          const count = endedAt(p.strokes[kind].seconds, now >= whole ? Infinity : now);
          part.geometry.setDrawRange(0, 2 * count);
          part.visible = p.on && (kind === 0 || rapids) && count > 0;
        });
      }
      reach();
      if (current && now < whole) {
        let latest = -1;
        current.strokes.forEach((strokes) => {
          const count = endedAt(strokes.seconds, now);
          if (count > 0 && strokes.seconds[count - 1] > latest) {
            latest = strokes.seconds[count - 1];
            tip = Array.from(strokes.places.slice(6 * count - 3, 6 * count));
          }
        });
      }
      for (const number of Object.keys(tools)) {
        const tool = tools[number];
        tool.visible = tip !== null && Number(number) === current.path.tool;
        if (tool.visible)
          tool.position.set(tip[0], tip[1], tip[2]);
      }
      byId('view-now').textContent = now >= whole ? 'the end, ' + clock(whole)
        : clock(now) + ' of ' + clock(whole) + ': ' + (current ? current.path.label : '');
      draw();
    }
    const inputs = paths.map((p) =>
      control(byId('view-paths'), 'checkbox', 'path', p.path.label + ', ' + clock(p.path.seconds), p.on, (on) => {
        p.on = on;
        showPaths();
      }, p.path.colour));
    if (paths.length > 0) {
      control(byId('view-things'), 'checkbox', 'rapids', 'rapids (dashed) of shown paths', rapids, (on) => {
        rapids = on;
        showPaths();
      });
      byId('view-accuracy').textContent = 'Paths are drawn to ' + scene.paths.off.toPrecision(2) +
        ' mm, surfaces in cells of ' + fields.cell.toPrecision(2) + ' mm.';
    }
    else
      byId('view-paths').hidden = byId('view-time').hidden = true;

    // A path that is looked for while the program runs is one that must be seen.
    byId('view-share').addEventListener('input', (event) => {
      now = scene.paths.seconds * event.target.value / event.target.max;
      if (!paths.some((p) => p.on))
        paths.forEach((p, i) => { p.on = inputs[i].checked = true; });
      showPaths();
    });
    document.querySelectorAll('[data-all]').forEach((button) =>
      button.addEventListener('click', () => {
        paths.forEach((p, i) => { p.on = inputs[i].checked = button.dataset.all !== ''; });
        showPaths();
      }));
    document.querySelectorAll('[data-look]').forEach((button) =>
      button.addEventListener('click', () => look(button.dataset.look)));

    place.addEventListener('keydown', (event) => {
      const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
      const away = new THREE.Vector3().subVectors(camera.position, orbit.target);
      if (turns[event.key]) {
        const zUp = new THREE.Spherical().setFromVector3(new THREE.Vector3(away.x, away.z, -away.y));
        zUp.theta += turns[event.key][0] * Math.PI / 18;
        zUp.phi = Math.min(Math.PI - 1e-4, Math.max(1e-4, zUp.phi + turns[event.key][1] * Math.PI / 18));
        const turned = new THREE.Vector3().setFromSpherical(zUp);
        camera.position.copy(orbit.target).add(new THREE.Vector3(turned.x, -turned.z, turned.y));
      }
      else if (event.key === '+' || event.key === '-') {
        camera.zoom *= event.key === '+' ? 1.2 : 1 / 1.2;
        camera.updateProjectionMatrix();
      }
      else
        return;
      event.preventDefault();
      orbit.update();
      draw();
    });

    // What tests ask: the colours that are seen.
    window.pointmillView = {
      pixels: () => {
        renderer.render(world, camera);
        const bytes = new Uint8Array(4 * canvas.width * canvas.height);
        context.readPixels(0, 0, canvas.width, canvas.height, context.RGBA, context.UNSIGNED_BYTE, bytes);
        return bytes;
      }
    };

    window.addEventListener('resize', fit);
    fit();
    look('iso');
    showSurface(first);
    showPaths();
    renderer.render(world, camera);
    root.dataset.view = 'ready';
  }

  start();
})();
