// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pcl/exceptions.h>

#include <string>

namespace pointmill {

/// @brief What would make an NC program wrong. Everything that PointMill throws derives
/// from it; a stage that throws has not touched its output.
class Error : public pcl::PCLException {
public:
  explicit Error(const std::string& what) : pcl::PCLException(what), what_(what) {}
  /// @brief The message alone; PCL's own would begin with an empty place.
  const char* what() const noexcept override { return what_.c_str(); }

private:
  std::string what_;
};

/// @brief A parameter is outside its range or contradicts another one.
class ParameterError : public Error {
public:
  using Error::Error;
};

/// @brief The input cannot be milled: empty, unreadable, degenerate, or of an absurd
/// size.
class DataError : public Error {
public:
  using Error::Error;
};

/// @brief The written program failed its verification.
class VerificationError : public Error {
public:
  using Error::Error;
};

} // namespace pointmill
