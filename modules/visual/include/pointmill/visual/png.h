// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <string>

class vtkImageData;

namespace pointmill::visual {

/// @brief Writes a picture as a PNG, beside its place first and renamed then.
/// @throws DataError where @p path cannot be written; nothing is left then
void writePng(const std::string& path, vtkImageData* image);

} // namespace pointmill::visual
