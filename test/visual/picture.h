// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <gtest/gtest.h>

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

/// A folder of its own that goes with the test.
class TemporaryFolder {
public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("pointmill_visual_" + std::to_string(getpid())))
  {
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  bool empty() const { return std::filesystem::is_empty(path_); }
  std::size_t files() const
  {
    using Files = std::filesystem::directory_iterator;
    return std::distance(Files(path_), Files());
  }

private:
  std::filesystem::path path_;
};

inline std::string readBytes(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

using Pixel = std::array<int, 3>;

/// A PNG read back; y runs down.
class Picture {
public:
  explicit Picture(const std::string& path)
  {
    reader_->SetFileName(path.c_str());
    reader_->Update();
    image_ = reader_->GetOutput();
  }
  int width() const { return image_->GetDimensions()[0]; }
  int height() const { return image_->GetDimensions()[1]; }
  int channels() const { return image_->GetNumberOfScalarComponents(); }
  Pixel at(int x, int y) const
  {
    const auto* p = static_cast<const unsigned char*>(
        image_->GetScalarPointer(x, height() - 1 - y, 0));
    return {p[0], p[1], p[2]};
  }
  /// How many pixels of columns [left, right) and rows [top, bottom) pass.
  template <typename Test>
  int count(int left, int right, int top, int bottom, const Test& test) const
  {
    int n = 0;
    for (int y = top; y < bottom; ++y)
      for (int x = left; x < right; ++x)
        n += test(at(x, y));
    return n;
  }
  int count(const Pixel& colour) const
  {
    return count(0, width(), 0, height(), [&](const Pixel& p) { return p == colour; });
  }

private:
  vtkNew<vtkPNGReader> reader_;
  vtkImageData* image_ = nullptr;
};
