// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <cstddef>
#include <memory>
#include <string>

namespace pointmill::detail {

/// @brief A whole file in memory, and the errors that name it.
class Source {
public:
  /// @throws DataError where @p path is no readable file or is empty
  explicit Source(const std::string& path);

  const char* begin() const { return data_.get(); }
  const char* end() const { return data_.get() + size_; }
  std::size_t size() const { return size_; }
  /// @brief What lies before @p at is this share of it.
  double shareBefore(const char* at) const
  {
    return double(at - begin()) / double(size_);
  }

  /// @brief Throws DataError "path: what".
  [[noreturn]] void fail(const std::string& what) const;
  /// @brief Throws DataError "path, line n: what" for the line that holds @p at.
  [[noreturn]] void failAt(const char* at, const std::string& what) const;
  /// @brief Throws DataError for a file that ends before its @p announced @p things.
  [[noreturn]] void failShort(unsigned long long announced, const char* things) const;

private:
  std::string path_;
  std::size_t size_ = 0;
  std::unique_ptr<char[]> data_;
};

} // namespace pointmill::detail
