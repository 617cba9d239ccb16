// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "program_files.h"

#include <algorithm>

namespace pointmill::gcode {

ProgramFiles::ProgramFiles(const GCodeWriter::Opener& open,
                           const Post& post,
                           const PrinterSettings& settings,
                           Series series)
    : open_(open), post_(post), settings_(settings), series_(series)
{
}

void ProgramFiles::begin(const ProgramHead& head)
{
  ++files_;
  std::string suffix;
  ProgramHead named = head;
  if (series_.count > 1) {
    const auto number = std::to_string(files_);
    suffix = "_" + number;
    if (series_.of_one_tool)
      suffix += "_T" + std::to_string(head.tools.front().number);
    named.name += suffix;
    named.comments.insert(named.comments.begin(),
                          "program " + number + " of " + std::to_string(series_.count));
  }
  printer_ = Printer::make(open_(suffix), post_, settings_);
  ++settings_.number;
  printer_->begin(named);
}

void ProgramFiles::end()
{
  printer_->end();
  lines_ += printer_->lines().lines();
  bytes_ += printer_->lines().bytes();
  longest_ = std::max(longest_, linesOfThis());
}

} // namespace pointmill::gcode
