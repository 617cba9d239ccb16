// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "post_option.h"

using pointmill::Post;

std::string postHelp()
{
  std::string names;
  for (const auto& name : Post::names())
    names += name + "|";
  return names + "FILE.yaml";
}

Post readPost(const std::string& name)
{
  return name.find_first_of("./") != std::string::npos ? Post::fromFile(name)
                                                       : Post::named(name);
}
