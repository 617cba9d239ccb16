// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/mill/check.h>
#include <pointmill/visual/finding_picture.h>

namespace pointmill {

/// @brief What the pictures of a judgement's findings show. The judgement must stay.
class FindingPicture {
public:
  FindingPicture(const std::string& title,
                 const Judgement& judgement,
                 const Criteria& criteria);
  FindingPicture(const FindingPicture&) = delete;
  FindingPicture& operator=(const FindingPicture&) = delete;

  const FindingScene& scene() const { return scene_; }

private:
  pcl::PointCloud<pcl::PointXYZ> part_;
  FindingScene scene_;
};

} // namespace pointmill
