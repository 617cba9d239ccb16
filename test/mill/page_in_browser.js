// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// Appended to a copy of a page by page_in_browser.cmake: uses the 3D view as a person
// would and says in the document what became of it.
(function () {
  'use strict';
  const root = document.documentElement;
  const wrong = [];
  window.addEventListener('error', (event) => wrong.push(event.message));

  function expect(what, fact) {
    if (!fact)
      wrong.push(what);
  }
  const by = (selector) => document.querySelector(selector);

  // How many pixels are far from the background, and how many of these have a colour.
  function seen() {
    const bytes = window.pointmillView.pixels();
    let drawn = 0, coloured = 0, sum = 0;
    for (let i = 0; i < bytes.length; i += 4) {
      const low = Math.min(bytes[i], bytes[i + 1], bytes[i + 2]);
      const high = Math.max(bytes[i], bytes[i + 1], bytes[i + 2]);
      if (low < 235) {
        ++drawn;
        coloured += high - low > 40;
        sum += bytes[i] + 3 * bytes[i + 1] + 7 * bytes[i + 2];
      }
    }
    return { all: bytes.length / 4, drawn: drawn, coloured: coloured, sum: sum };
  }
  // How many pixels of the picture's rim are drawn on: what is there is cut off.
  function cutOff() {
    const bytes = window.pointmillView.pixels();
    const canvas = by('#view-canvas canvas'), columns = canvas.width, rows = canvas.height;
    let drawn = 0;
    for (let i = 0; i < columns * rows; ++i) {
      const column = i % columns, row = Math.floor(i / columns);
      if ((column === 0 || row === 0 || column === columns - 1 || row === rows - 1) && bytes[4 * i] < 235)
        ++drawn;
    }
    return drawn;
  }
  function use(selector, value) {
    const input = by(selector);
    if (value === undefined)
      input.click();
    else {
      input.value = value;
      input.dispatchEvent(new Event('input'));
    }
    return seen();
  }

  function run() {
    expect('the view is ready', root.dataset.view === 'ready');
    expect('the view is in sight', !by('#view').hidden && by('#view-canvas').clientHeight > 300);
    const milled = seen();
    expect('the part fills a good share of the view: ' + milled.drawn, milled.drawn > 0.15 * milled.all);
    expect('it is grey: ' + milled.coloured, milled.coloured < 0.1 * milled.drawn);
    const scan = use('input[value=part]');
    expect('heights have colours: ' + scan.coloured, scan.coloured > 0.3 * scan.drawn);
    const deviation = use('input[value=deviation]');
    expect('deviations look otherwise', deviation.sum !== scan.sum && deviation.sum !== milled.sum);
    expect('their scale is in sight', !by('#view-scale').hidden);
    const none = use('input[value=none]');
    const bare = use('input[name=zones]');
    expect('zones can be left out', bare.drawn < none.drawn);
    expect('without a surface little is left: ' + bare.drawn, bare.drawn < 0.1 * milled.drawn);
    const all = use('[data-all=yes]');
    expect('paths are drawn: ' + all.drawn, all.drawn > 2 * bare.drawn);
    expect('in colours', all.coloured > 1000);
    const rapids = use('input[name=rapids]');
    expect('rapids too', rapids.sum !== all.sum);
    use('input[name=plane]');
    for (const look of ['iso', 'top', 'front', 'right']) {
      use('[data-look=' + look + ']');
      expect('all that is shown is in the picture: ' + look, cutOff() === 0);
    }
    use('input[name=plane]');
    use('[data-look=iso]');
    const begun = use('#view-share', 20);
    expect('fewer at the beginning: ' + begun.drawn, begun.drawn < all.drawn);
    expect('the operation is named', / of .*: 1  /.test(by('#view-now').textContent));
    use('#view-share', 1000);
    const gone = use('[data-all=""]');
    expect('none when none are wanted: ' + gone.drawn, gone.drawn === bare.drawn);
    use('input[value=milled]');
    const pictures = {};
    for (const look of ['iso', 'top', 'front', 'right'])
      pictures[use('[data-look=' + look + ']').sum] = look;
    expect('each side looks otherwise', Object.keys(pictures).length === 4);
    const before = use('[data-look=reset]').sum;
    by('#view-canvas').dispatchEvent(new KeyboardEvent('keydown', { key: 'ArrowLeft' }));
    expect('keys turn it', seen().sum !== before);
    expect('nothing is wider than the page', root.scrollWidth <= root.clientWidth);
  }

  try {
    run();
  }
  catch (error) {
    wrong.push(String(error));
  }
  root.dataset.test = wrong.length > 0 ? 'FAILED: ' + wrong.join('; ') : 'passed';
})();
