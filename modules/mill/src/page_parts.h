// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/check.h>
#include <pointmill/page/html.h>

#include <string>
#include <utility>
#include <vector>

namespace pointmill {

/// @brief Sections that the pages of jobs and of checks share.
namespace page {

/// @brief A picture that stands in a file.
struct PictureFile {
  std::string path, alt, caption;
};
Html of(const PictureFile& picture);

/// @brief What a page says first, in words, with a sign and a colour.
enum class Verdict { Passed, Warned, Refused };
Html verdict(Verdict verdict, const std::string& words, const std::string& more);
/// @brief That of a program: its errors, or its warnings.
Html verdictOf(const Verification& verification);

/// @brief Large figures, each with what it is.
Html tiles(const std::vector<std::pair<std::string, std::string>>& figures);
/// @brief Terms and what there is to say of each.
Html terms(const std::vector<std::pair<std::string, Html>>& list);

/// @brief What was found, each with a section through its place.
/// @param scratch file that its pictures pass through, and that is left behind
/// @param overview the picture of all findings. It holds the section of the worst one,
/// so that a single finding has none of its own beside it.
Html findings(const Judgement& judgement,
              const Criteria& criteria,
              const std::string& scratch,
              const Html& overview);

/// @brief How near the milled part comes to the scan, in figures and as a chart.
Html accuracy(const Judgement& judgement, const Criteria& criteria);

/// @brief The figures of the tiles that tell whether a program is good.
std::vector<std::pair<std::string, std::string>> figuresOf(const Judgement& judgement,
                                                           const Criteria& criteria);

/// @brief A length of time with its share of the whole as a bar.
Html timeBar(double minutes, double whole, const std::string& colour);
/// @brief A patch of a colour, before what it stands for.
Html swatch(const std::string& colour);

} // namespace page
} // namespace pointmill
