// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "canvas_png.h"

#include <pointmill/common/error.h>
#include <pointmill/visual/png.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace pointmill::visual {

void writePng(const std::string& path, const Canvas& canvas)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(canvas.width(), canvas.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < canvas.height(); ++y) // VTK counts rows from the bottom
    std::memcpy(image->GetScalarPointer(0, canvas.height() - 1 - y, 0),
                canvas.row(y),
                3 * static_cast<std::size_t>(canvas.width()));
  writePng(path, image);
}

void writePng(const std::string& path, vtkImageData* image)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetCompressionLevel(6); // 9 takes several times as long for few per cent
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfTuples() == 0)
    throw DataError(path + ": the picture cannot be encoded");

  const std::string beside = path + "." + std::to_string(getpid()) + ".part";
  std::ofstream file(beside, std::ios::binary);
  file.write(reinterpret_cast<const char*>(writer->GetResult()->GetPointer(0)),
             writer->GetResult()->GetNumberOfTuples());
  file.close();
  std::error_code error;
  if (file)
    std::filesystem::rename(beside, path, error);
  if (!file || error) {
    std::error_code ignored;
    std::filesystem::remove(beside, ignored);
    throw DataError(path + ": cannot be written" +
                    (error ? ", " + error.message() : std::string()));
  }
}

} // namespace pointmill::visual
