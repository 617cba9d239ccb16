// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "readers.h"
#include "scalar.h"
#include "text.h"

#include <pointmill/common/watch.h>

#include <cmath>
#include <limits>

// Not pcl::PLYReader: it takes no double coordinates and no strips, and says neither.
namespace pointmill::detail {

namespace {

using Count = unsigned long long;

struct Property {
  std::string name;
  Scalar type;
  bool list;
  Scalar count_type; // of a list
};

struct Element {
  std::string name;
  Count count;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  Text body{nullptr, nullptr};
};

bool scalarNamed(const std::string& name, Scalar& type)
{
  constexpr const char* names[][2] = {{"char", "int8"},
                                      {"uchar", "uint8"},
                                      {"short", "int16"},
                                      {"ushort", "uint16"},
                                      {"int", "int32"},
                                      {"uint", "uint32"},
                                      {"int64", "int64"},
                                      {"uint64", "uint64"},
                                      {"float", "float32"},
                                      {"double", "float64"}};
  for (int i = 0; i < 10; ++i)
    if (name == names[i][0] || name == names[i][1]) {
      type = static_cast<Scalar>(i);
      return true;
    }
  return false;
}

bool readProperty(Text& line, Element& element)
{
  Property property{};
  std::string type = takeWord(line);
  if (type == "list") {
    property.list = true;
    if (!scalarNamed(takeWord(line), property.count_type))
      return false;
    type = takeWord(line);
  }
  property.name = takeWord(line);
  element.properties.push_back(property);
  return scalarNamed(type, element.properties.back().type) && !property.name.empty();
}

Header readHeader(const Source& source)
{
  Header header;
  Text rest{source.begin(), source.end()};
  Text line{};
  takeLine(rest, line);
  if (takeWord(line) != "ply" || !takeWord(line).empty())
    source.fail("is not a PLY file; save it as PLY or name it as it is");
  while (takeLine(rest, line)) {
    const Text whole = line;
    const std::string key = takeWord(line);
    bool good = true;
    if (key.empty() || key == "comment" || key == "obj_info")
      continue;
    if (key == "end_header") {
      header.body = rest;
      return header;
    }
    if (key == "format")
      header.format = takeWord(line);
    else if (key == "element") {
      Element element{takeWord(line), 0, {}};
      good = takeWholeNumber(line, element.count);
      header.elements.push_back(element);
    }
    else if (key == "property")
      good = !header.elements.empty() && readProperty(line, header.elements.back());
    else
      good = false;
    if (!good)
      source.failAt(whole.at,
                    "the PLY header says " + quoted(whole) +
                        ", which is unknown; export the scan again");
  }
  source.fail("is cut short within its PLY header; copy or export it again");
}

/// Takes values from the rows of an ASCII body: one row per item, as the format says.
class AsciiBody {
public:
  AsciiBody(const Source& source, Text body) : source_(source), rest_(body) {}

  void startItem(const Element& element)
  {
    do {
      if (!takeLine(rest_, line_))
        source_.failShort(element.count, element.name.c_str());
      whole_ = line_;
      skipBlanks(line_);
    } while (line_.done());
  }
  double take(Scalar)
  {
    double value;
    if (!takeWholeNumber(line_, value))
      failItem();
    return value;
  }
  void endItem()
  {
    skipBlanks(line_);
    if (!line_.done())
      failItem();
  }
  void end()
  {
    while (takeLine(rest_, line_)) {
      whole_ = line_;
      endItem();
    }
  }
  /// Whether `count` items of at least `columns` values, `bytes` in binary, can follow.
  bool holds(Count count, Count columns, Count)
  {
    return count <= static_cast<Count>(rest_.end - rest_.at + 1) / (2 * columns);
  }
  /// The same for a list of numbers of `bytes` in the item that is being taken.
  bool itemHolds(Count count, Count)
  {
    return count <= static_cast<Count>(line_.end - line_.at + 1) / 2;
  }
  [[noreturn]] void failItem() const
  {
    source_.failAt(line_.at,
                   quoted(whole_) + " is not the row of values that the "
                                    "header announces; export the scan again");
  }

private:
  const Source& source_;
  Text rest_;
  Text line_{nullptr, nullptr};
  Text whole_{nullptr, nullptr};
};

class BinaryBody {
public:
  BinaryBody(const Source& source, Text body, bool swap)
      : source_(source), rest_(body), swap_(swap)
  {
  }

  void startItem(const Element& element) { element_ = &element; }
  double take(Scalar type)
  {
    const std::size_t size = sizeOf(type);
    if (static_cast<std::size_t>(rest_.end - rest_.at) < size)
      source_.failShort(element_->count, element_->name.c_str());
    const double value = load(type, rest_.at, swap_);
    rest_.at += size;
    return value;
  }
  void endItem() {}
  void end() {}
  bool holds(Count count, Count, Count bytes)
  {
    return count <= static_cast<Count>(rest_.end - rest_.at) / bytes;
  }
  bool itemHolds(Count count, Count bytes) { return holds(count, 1, bytes); }
  [[noreturn]] void failItem() const
  {
    source_.fail("is cut short or damaged: an item of '" + element_->name +
                 "' has an impossible index or length; copy or export it again");
  }

private:
  const Source& source_;
  Text rest_;
  bool swap_;
  const Element* element_ = nullptr;
};

void addStrip(const std::vector<std::uint32_t>& strip, RawScan& scan)
{
  for (std::size_t i = 2; i < strip.size(); ++i) {
    auto a = strip[i - 2], b = strip[i - 1];
    const auto c = strip[i];
    // Every other triangle of a strip runs the other way round.
    if (i % 2 == 1)
      std::swap(a, b);
    if (a != b && b != c && a != c)
      scan.faces.push_back({a, b, c});
  }
}

template <typename Body>
class BodyReader {
public:
  BodyReader(Body body, const Source& source, RawScan& scan)
      : body_(body), source_(source), scan_(scan)
  {
  }

  void read(const std::vector<Element>& elements)
  {
    for (const Element& element : elements) {
      if (element.count == 0)
        continue;
      Count bytes = 0;
      for (const Property& property : element.properties)
        bytes += sizeOf(property.list ? property.count_type : property.type);
      // Before anything is allocated.
      if (bytes == 0 || !body_.holds(element.count, element.properties.size(), bytes))
        source_.failShort(element.count, element.name.c_str());
      if (element.name == "vertex")
        readVertices(element);
      else
        readOthers(element);
    }
    body_.end();
  }

private:
  void skip(const Property& property)
  {
    for (Count n = property.list ? takeLength(property) : 1; n > 0; --n)
      body_.take(property.type);
  }

  Count takeLength(const Property& property)
  {
    const double length = body_.take(property.count_type);
    if (!(length >= 0 && length <= 1e10) || length != std::floor(length))
      body_.failItem();
    const auto count = static_cast<Count>(length);
    if (!body_.itemHolds(count, sizeOf(property.type)))
      body_.failItem();
    return count;
  }

  void readVertices(const Element& element)
  {
    std::vector<int> axis_of(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
      bool found = false;
      for (std::size_t i = 0; i < axis_of.size(); ++i)
        if (!element.properties[i].list &&
            element.properties[i].name ==
                std::string(1, static_cast<char>('x' + axis))) {
          axis_of[i] = axis;
          found = true;
        }
      if (!found)
        source_.fail("its vertices lack x, y or z; export the scan with all three");
    }
    scan_.points.reserve(scan_.points.size() + element.count);
    for (Count n = 0; n < element.count; ++n) {
      checkInterrupted();
      body_.startItem(element);
      Eigen::Vector3d point;
      for (std::size_t i = 0; i < axis_of.size(); ++i)
        if (axis_of[i] >= 0)
          point[axis_of[i]] = body_.take(element.properties[i].type);
        else
          skip(element.properties[i]);
      body_.endItem();
      scan_.points.push_back(point);
    }
  }

  // Faces, strips, and what is none of PointMill's business.
  void readOthers(const Element& element)
  {
    const bool strips = element.name == "tristrips";
    const bool shapes = strips || element.name == "face";
    std::vector<std::uint32_t> corners;
    for (Count n = 0; n < element.count; ++n) {
      checkInterrupted();
      body_.startItem(element);
      for (const Property& property : element.properties) {
        const bool wanted =
            shapes && property.list &&
            (property.name == "vertex_indices" || property.name == "vertex_index");
        if (!wanted) {
          skip(property);
          continue;
        }
        corners.clear();
        for (Count left = takeLength(property); left > 0; --left) {
          const double index = body_.take(property.type);
          if (strips && index == -1) {
            addStrip(corners, scan_);
            corners.clear();
          }
          else if (index >= 0 && index < std::numeric_limits<std::uint32_t>::max() &&
                   index == std::floor(index))
            corners.push_back(static_cast<std::uint32_t>(index));
          else
            body_.failItem();
        }
        if (strips)
          addStrip(corners, scan_);
        else
          addFan(corners, scan_);
      }
      body_.endItem();
    }
  }

  Body body_;
  const Source& source_;
  RawScan& scan_;
};

} // namespace

RawScan readPly(const Source& source)
{
  const Header header = readHeader(source);
  RawScan scan;
  scan.format = "PLY";
  if (header.format == "ascii")
    BodyReader<AsciiBody>({source, header.body}, source, scan).read(header.elements);
  else if (header.format == "binary_little_endian")
    BodyReader<BinaryBody>({source, header.body, false}, source, scan)
        .read(header.elements);
  else if (header.format == "binary_big_endian")
    BodyReader<BinaryBody>({source, header.body, true}, source, scan)
        .read(header.elements);
  else
    source.fail("its PLY format '" + header.format +
                "' is unknown; save it as binary_little_endian");
  return scan;
}

} // namespace pointmill::detail
