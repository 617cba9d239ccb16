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

bool render(const std::string& text, const TextStyle& style, vtkImageData* image)
{
  if (text.find_first_not_of(' ') == std::string::npos)
    return false;
  vtkNew<vtkTextProperty> property;
  property->SetFontFamilyToArial(); // built into VTK: no font has to be installed
  property->SetFontSize(style.size);
  property->SetBold(style.bold);
  property->SetColor(1.0, 1.0, 1.0);
  vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
  tools->ScaleToPowerTwoOff();
  int used[2] = {0, 0};
  return tools->RenderString(property, toVtk(text), kDpi, image, used) &&
         image->GetNumberOfScalarComponents() == 4;
}

} // namespace

int textWidth(const std::string& text, const TextStyle& style)
{
  vtkNew<vtkImageData> image;
  return render(printable(text), style, image) ? image->GetDimensions()[0] : 0;
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
  std::string line = printable(text);
  if (textWidth(line, style) <= width)
    return line;
  while (!line.empty()) {
    // Whole characters, not bytes of UTF-8.
    while (line.size() > 1 && (static_cast<unsigned char>(line.back()) & 0xC0) == 0x80)
      line.pop_back();
    line.pop_back();
    if (textWidth(line + "...", style) <= width)
      return line + "...";
  }
  return line;
}

} // namespace pointmill::visual
