// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
// VTK 9.1 drops every non-ASCII character unless it gets its own string class, which it
// already calls deprecated; from 9.2 on it takes UTF-8.
#define VTK_DEPRECATION_LEVEL 0

#include "text.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkVersionMacros.h>

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
#include <vtkUnicodeString.h>
#endif

#include <algorithm>
#include <vector>

namespace pointmill::visual {

namespace {

constexpr int kDpi = 72; // one point is one pixel

#if VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION < 2
bool isUtf8(const std::string& text)
{
  return vtkUnicodeString::is_utf8(text);
}
vtkUnicodeString toVtk(const std::string& text)
{
  return vtkUnicodeString::from_utf8(text);
}
#else
bool isUtf8(const std::string&)
{
  return true;
}
vtkStdString toVtk(const std::string& text)
{
  return text;
}
#endif

/// One printable line: file names may hold anything.
std::string printable(std::string text)
{
  const bool utf8 = isUtf8(text);
  for (char& c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F || (!utf8 && byte > 0x7F))
      c = byte < 0x20 ? ' ' : '?';
  }
  return text;
}

bool isBlank(const std::string& text)
{
  return text.find_first_not_of(' ') == std::string::npos;
}

vtkFreeTypeTools* freeType()
{
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  return tools;
}

vtkNew<vtkTextProperty> propertyOf(const TextStyle& style)
{
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial(); // built into VTK: no font has to be installed
  property->SetFontSize(style.size);
  property->SetBold(style.bold);
  property->SetColor(1.0, 1.0, 1.0);
  return property;
}

bool render(const std::string& text, const TextStyle& style, vtkImageData* image)
{
  int used[2] = {0, 0};
  return !isBlank(text) &&
         freeType()->RenderString(propertyOf(style), toVtk(text), kDpi, image, used) &&
         image->GetNumberOfScalarComponents() == 4;
}

} // namespace

int textWidth(const std::string& text, const TextStyle& style)
{
  const std::string line = printable(text);
  int box[4]; // of the image that render() makes
  if (isBlank(line) ||
      !freeType()->GetBoundingBox(propertyOf(style), toVtk(line), kDpi, box))
    return 0;
  return box[1] - box[0] + 1;
}

int drawText(Canvas& canvas,
             int x,
             int y_middle,
             const std::string& text,
             const TextStyle& style)
{
  vtkNew<vtkImageData> image;
  if (!render(printable(text), style, image))
    return 0;
  const int* size = image->GetDimensions();
  int extent[6];
  image->GetExtent(extent);
  const auto* pixels = static_cast<const unsigned char*>(
      image->GetScalarPointer(extent[0], extent[2], extent[4]));
  const int top = y_middle - size[1] / 2;
  for (int row = 0; row < size[1]; ++row)
    for (int column = 0; column < size[0]; ++column) {
      const unsigned char alpha = pixels[4 * (row * size[0] + column) + 3];
      canvas.blend(x + column,
                   top + size[1] - 1 - row,
                   style.colour,
                   static_cast<float>(alpha) / 255.f);
    }
  return size[0];
}

std::string fitText(const std::string& text, int width, const TextStyle& style)
{
  const std::string line = printable(text);
  if (textWidth(line, style) <= width)
    return line;
  std::vector<std::size_t> ends; // between whole characters, not bytes of UTF-8
  for (std::size_t i = 0; i < line.size(); ++i)
    if ((static_cast<unsigned char>(line[i]) & 0xC0) != 0x80)
      ends.push_back(i);
  const auto shortened = [&](std::size_t end) { return line.substr(0, end) + "..."; };
  const auto wide =
      std::partition_point(ends.begin(), ends.end(), [&](std::size_t end) {
        return textWidth(shortened(end), style) <= width;
      });
  return wide == ends.begin() ? "" : shortened(wide[-1]);
}

} // namespace pointmill::visual
