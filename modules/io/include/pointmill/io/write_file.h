// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <functional>
#include <iosfwd>
#include <string>

namespace pointmill {

/// @brief Lets @p body write a new file beside @p path and renames it to @p path when
/// all of it is on the disk: whoever looks sees the old file or the new one, whole. The
/// stream is binary and writes numbers the same way in every locale.
/// @throws DataError where the folder or the disk does not take it, and what @p body
/// threw, if that is another Error; nothing stays behind then
void writeFileAtomically(const std::string& path,
                         const std::function<void(std::ostream&)>& body);

} // namespace pointmill
