// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "scalar.h"
#include "text.h"

#include <pointmill/common/watch.h>

#include <pcl/io/lzf.h>

// Not pcl::PCDReader: it allocates whatever the header announces before it looks at the
// data.
namespace pointmill::detail {

namespace {

using Count = unsigned long long;

struct Field {
  std::string name;
  Count size = 4;
  char type = 'F';
  Count count = 1;
};

struct Header {
  std::vector<Field> fields;
  Count width = 0, height = 1, points = 0;
  bool has_width = false, has_points = false;
  std::string data;
  Text body{nullptr, nullptr};
};

constexpr const char* no_pcd = "is not a PCD file; save it as PCD or name it as it is";

Scalar scalarOf(const Field& field, const Source& source)
{
  const std::string code = field.type + std::to_string(field.size);
  constexpr const char* codes[] = {
      "I1", "U1", "I2", "U2", "I4", "U4", "I8", "U8", "F4", "F8"};
  for (int i = 0; i < 10; ++i)
    if (code == codes[i])
      return static_cast<Scalar>(i);
  source.fail("its PCD field '" + field.name + "' has the unknown type " + code +
              "; export it again");
}

// Reads one value per field with `set(field, word)`.
template <typename Set>
void eachField(Header& header, Text& line, const Source& source, Set set)
{
  for (Field& field : header.fields) {
    skipBlanks(line);
    if (line.done() || !set(field, line))
      source.failAt(line.at,
                    "the PCD header does not describe every field; export the "
                    "scan again");
  }
}

Header readHeader(const Source& source)
{
  constexpr Count most = 0xffffffffu;
  Header header;
  Text rest{source.begin(), source.end()};
  Text line{};
  const WorkStep step({0.0, 1.0});
  while (takeLine(rest, line)) {
    step.reach(source.shareBefore(line.at));
    const Text whole = line;
    const std::string key = takeWord(line);
    const auto number = [&](Text& text, Count& value, Count limit) {
      return takeWholeNumber(text, value) && value <= limit;
    };
    bool good = true;
    if (key.empty() || key[0] == '#' || key == "VERSION" || key == "VIEWPOINT")
      continue;
    if (key == "FIELDS" || key == "COLUMNS") {
      for (std::string name; !(name = takeWord(line)).empty();) {
        header.fields.emplace_back();
        header.fields.back().name = name;
      }
    }
    else if (key == "SIZE")
      eachField(header, line, source, [&](Field& field, Text& text) {
        return number(text, field.size, 8);
      });
    else if (key == "TYPE")
      eachField(header, line, source, [&](Field& field, Text& text) {
        field.type = takeWord(text)[0];
        return true;
      });
    else if (key == "COUNT")
      eachField(header, line, source, [&](Field& field, Text& text) {
        return number(text, field.count, 1000000);
      });
    else if (key == "WIDTH")
      good = header.has_width = number(line, header.width, most);
    else if (key == "HEIGHT")
      good = number(line, header.height, most);
    else if (key == "POINTS")
      good = header.has_points = number(line, header.points, most * most);
    else if (key == "DATA") {
      header.data = takeWord(line);
      header.body = rest;
      break;
    }
    else
      source.fail(no_pcd);
    if (!good)
      source.failAt(whole.at,
                    "the PCD header says " + quoted(whole) +
                        ", which is no count; export the scan again");
  }
  if (header.fields.empty() || header.data.empty())
    source.fail(no_pcd);
  if (!header.has_points)
    header.points = header.width * header.height;
  else if (header.has_width && header.width * header.height != header.points)
    source.fail("its PCD header contradicts itself: WIDTH x HEIGHT is not POINTS; "
                "export the scan again");
  return header;
}

std::size_t indexOf(const std::string& name, const Header& header, const Source& source)
{
  for (std::size_t i = 0; i < header.fields.size(); ++i)
    if (header.fields[i].name == name && header.fields[i].count == 1)
      return i;
  source.fail("has no field '" + name + "'; export the scan with x, y and z");
}

constexpr const char* no_numbers = " is not a row of numbers; export the scan again";

// With `all`, what stands beside x, y and z must be numbers too.
void readAscii(const Header& header,
               const std::array<std::size_t, 3>& axes,
               bool all,
               const Source& source,
               RawScan& scan)
{
  // In words per row.
  std::array<Count, 3> column{};
  Count columns = 0;
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      if (axes[axis] == i)
        column[axis] = columns;
    columns += header.fields[i].count;
  }
  Text rest = header.body;
  // A row takes at least one digit and one blank per column.
  if (header.points > static_cast<Count>(rest.end - rest.at + 1) / (2 * columns))
    source.failShort(header.points, "points");
  scan.points.reserve(header.points);
  Text line{};
  while (takeLine(rest, line)) {
    const Text whole = line;
    skipBlanks(line);
    if (line.done())
      continue;
    if (scan.points.size() == header.points)
      source.failAt(line.at,
                    "more points than the " + std::to_string(header.points) +
                        " announced; correct WIDTH, HEIGHT and POINTS");
    Eigen::Vector3d point;
    Count word = 0;
    for (; word < columns && !line.done(); ++word, skipBlanks(line)) {
      bool wanted = false;
      for (int axis = 0; axis < 3; ++axis)
        if (column[axis] == word) {
          wanted = true;
          if (!takeWholeNumber(line, point[axis]))
            source.failAt(whole.at, quoted(whole) + no_numbers);
        }
      double number = 0;
      if (!wanted && !all)
        skipWord(line);
      else if (!wanted && !takeWholeNumber(line, number))
        source.failAt(whole.at, quoted(whole) + no_numbers);
    }
    if (word < columns || !line.done())
      source.failAt(whole.at,
                    "a row of " + std::to_string(columns) +
                        " values was expected; copy or export the scan again");
    scan.points.push_back(point);
  }
  if (scan.points.size() < header.points)
    source.failShort(header.points, "points");
}

// Where one coordinate of every point stands.
struct Column {
  const char* first;
  std::size_t stride;
  Scalar type;
};

void readColumns(const std::array<Column, 3>& columns, Count points, RawScan& scan)
{
  scan.points.resize(points);
  for (int axis = 0; axis < 3; ++axis) {
    const char* from = columns[axis].first;
    checkInterrupted();
    for (auto& point : scan.points) {
      point[axis] = load(columns[axis].type, from);
      from += columns[axis].stride;
    }
  }
}

// Bytes of a point.
Count rowOf(const Header& header)
{
  Count row = 0;
  for (const Field& field : header.fields)
    row += field.size * field.count;
  return row;
}

void checkBinary(const Header& header, Count row, const Source& source)
{
  if (header.points > static_cast<Count>(header.body.end - header.body.at) / row)
    source.failShort(header.points, "points");
}

struct Packed {
  Count size = 0, unpacked = 0;
};

constexpr const char* broken =
    "its compressed data is damaged; copy or export it again";

// The size before compression stands in the file twice: in the data and as the product
// of the header's counts.
Packed checkCompressed(const Header& header, Count row, const Source& source)
{
  const Text body = header.body;
  const auto held = static_cast<Count>(body.end - body.at);
  if (held < 8)
    source.failShort(header.points, "points");
  const Packed packed{loadAs<std::uint32_t>(body.at),
                      loadAs<std::uint32_t>(body.at + 4)};
  if (packed.size > held - 8)
    source.failShort(header.points, "points");
  // LZF packs at most 264 bytes into 3: more is no honest size to allocate.
  if (header.points > packed.unpacked / row || header.points * row != packed.unpacked ||
      packed.unpacked / 88 > packed.size)
    source.fail(broken);
  return packed;
}

std::vector<char> decompress(const Header& header, Count row, const Source& source)
{
  const Packed packed = checkCompressed(header, row, source);
  std::vector<char> data(packed.unpacked);
  if (!data.empty() &&
      pcl::lzfDecompress(header.body.at + 8,
                         static_cast<unsigned>(packed.size),
                         data.data(),
                         static_cast<unsigned>(packed.unpacked)) != packed.unpacked)
    source.fail(broken);
  return data;
}

// The fields of x, y and z, with their types.
struct Axes {
  std::array<std::size_t, 3> fields{};
  std::array<Scalar, 3> types{};
};

Axes axesOf(const Header& header, const Source& source)
{
  Axes axes;
  for (int axis = 0; axis < 3; ++axis) {
    axes.fields[axis] =
        indexOf(std::string(1, static_cast<char>('x' + axis)), header, source);
    axes.types[axis] = scalarOf(header.fields[axes.fields[axis]], source);
  }
  return axes;
}

[[noreturn]] void failKind(const Header& header, const Source& source)
{
  source.fail("its PCD data is of the unknown kind '" + header.data +
              "'; save it as binary");
}

} // namespace

void checkPcd(const Source& source)
{
  const Header header = readHeader(source);
  const Axes axes = axesOf(header, source);
  const Count row = rowOf(header);
  if (header.data == "ascii") {
    RawScan rows; // each of them is to be one
    readAscii(header, axes.fields, true, source, rows);
  }
  else if (header.data == "binary")
    checkBinary(header, row, source);
  else if (header.data == "binary_compressed")
    checkCompressed(header, row, source);
  else
    failKind(header, source);
}

RawScan readPcd(const Source& source)
{
  const Header header = readHeader(source);
  RawScan scan;
  scan.format = "PCD";
  const Axes axes = axesOf(header, source);
  if (header.data == "ascii") {
    readAscii(header, axes.fields, false, source, scan);
    return scan;
  }
  const Count row = rowOf(header);
  std::array<Column, 3> columns{};
  const auto setColumns = [&](const char* data, bool by_field) {
    for (int axis = 0; axis < 3; ++axis) {
      Count before = 0; // bytes of a row before the field
      for (std::size_t i = 0; i < axes.fields[axis]; ++i)
        before += header.fields[i].size * header.fields[i].count;
      const Count size = header.fields[axes.fields[axis]].size;
      columns[axis] = {data + (by_field ? before * header.points : before),
                       by_field ? size : row,
                       axes.types[axis]};
    }
  };
  if (header.data == "binary") {
    checkBinary(header, row, source);
    setColumns(header.body.at, false);
    readColumns(columns, header.points, scan);
  }
  else if (header.data == "binary_compressed") {
    // All of the first field comes first, then all of the second, ...
    const std::vector<char> data = decompress(header, row, source);
    setColumns(data.data(), true);
    readColumns(columns, header.points, scan);
  }
  else
    failKind(header, source);
  return scan;
}

} // namespace pointmill::detail
