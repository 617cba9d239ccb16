// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include <pointmill/common/error.h>
#include <pointmill/common/parameters.h>
#include <pointmill/common/point_types.h>
#include <pointmill/common/report.h>
#include <pointmill/common/watch.h>

#include <pcl/filters/filter.h>
#include <pcl/filters/impl/filter.hpp>
#include <pcl/pcl_base.h>

#include <memory>
#include <string>
#include <utility>

namespace pointmill {

/// @brief A stage that turns a cloud of `In` into a cloud of `Out`, with the verbs of
/// PCL's filters: `setInputCloud`, `setIndices`, `filter(output)`. It reads only
/// `*indices_`, treats non-finite points as removed, and throws (pointmill::Error)
/// before it touches `output`, or not at all. A Watch tells how far it is and can stop
/// it.
///
/// A stage that keeps the point type is a `pcl::Filter<PointT>` instead; see @ref
/// Filter.
template <typename In, typename Out>
class Stage : public pcl::PCLBase<In> {
public:
  using OutputPoint = Out;
  using Output = pcl::PointCloud<Out>;

  explicit Stage(std::string name) : name_(std::move(name)) {}

  const std::string& getName() const { return name_; }
  /// @brief What the last run handled; empty before the first.
  const Report& getReport() const { return report_; }

  /// @throws ParameterError, DataError; the output is untouched then
  void filter(Output& output)
  {
    if (!this->input_)
      throw DataError(name_ + ": no input cloud was set");
    checkParameters();
    if (!this->initCompute() || this->indices_->empty())
      throw DataError(name_ + ": the input cloud or its indices are empty");
    const WorkStep whole({0.0, 1.0});
    Report fresh;
    std::swap(report_, fresh);
    Output result;
    apply(result);
    result.header = this->input_->header;
    this->deinitCompute();
    output.swap(result);
    output.header = this->input_->header;
  }

protected:
  virtual void checkParameters() const = 0;
  virtual void apply(Output& output) = 0;

  Report report_;

private:
  std::string name_;
};

/// @brief Base of the stages that keep the point type: a `pcl::Filter` that throws
/// instead of printing and leaves its output untouched when it does.
template <typename PointT>
class Filter : public pcl::Filter<PointT> {
public:
  using OutputPoint = PointT;
  using PointCloud = typename pcl::Filter<PointT>::PointCloud;

  explicit Filter(const std::string& name) { this->filter_name_ = name; }

  const std::string& getName() const { return this->getClassName(); }
  const Report& getReport() const { return report_; }

  /// @copydoc Stage::filter
  void filter(PointCloud& output)
  {
    if (!this->input_)
      throw DataError(getName() + ": no input cloud was set");
    const WorkStep whole({0.0, 1.0});
    PointCloud result;
    applied_ = false;
    pcl::Filter<PointT>::filter(result);
    if (!applied_)
      throw DataError(getName() + ": the input cloud or its indices are empty");
    output.swap(result);
    output.header = this->input_->header;
  }

protected:
  /// @brief What a derived class does; @p output is a fresh cloud.
  virtual void apply(PointCloud& output) = 0;
  virtual void checkParameters() const = 0;

  void applyFilter(PointCloud& output) final
  {
    checkParameters();
    if (this->indices_->empty())
      throw DataError(getName() + ": the input cloud or its indices are empty");
    report_.clear();
    PointCloud result;
    apply(result);
    result.header = output.header; // what pcl::Filter has set
    result.sensor_origin_ = output.sensor_origin_;
    result.sensor_orientation_ = output.sensor_orientation_;
    output.swap(result);
    applied_ = true;
  }

  Report report_;

private:
  bool applied_ = false;
};

namespace detail {
// Any pcl::Filter yields its own point type; a Stage names what it yields.
template <typename PointT>
PointT pointOf(const pcl::Filter<PointT>*);
template <typename In, typename Out>
Out pointOf(const Stage<In, Out>*);
template <typename F>
using OutputOf = decltype(pointOf(static_cast<F*>(nullptr)));
} // namespace detail

/// @brief Runs @p cloud through one filter after the other, PCL's and PointMill's
/// mixed; a chain whose point types do not fit is a compile error.
/// @return the last filter's cloud, never null
template <typename PointT, typename First, typename... Rest>
auto run(const std::shared_ptr<const pcl::PointCloud<PointT>>& cloud,
         First& first,
         Rest&... rest)
{
  using Out = detail::OutputOf<First>;
  typename pcl::PointCloud<Out>::Ptr next(new pcl::PointCloud<Out>);
  constexpr double share = 1.0 / (1 + sizeof...(rest));
  {
    const WorkStep step({0.0, share});
    first.setInputCloud(cloud);
    first.filter(*next);
  }
  const WorkStep others({share, 1.0});
  if constexpr (sizeof...(rest) == 0)
    return next;
  else
    return run<Out>(typename pcl::PointCloud<Out>::ConstPtr(next), rest...);
}
template <typename PointT, typename First, typename... Rest>
auto run(const std::shared_ptr<pcl::PointCloud<PointT>>& cloud,
         First& first,
         Rest&... rest)
{
  return run<PointT>(typename pcl::PointCloud<PointT>::ConstPtr(cloud), first, rest...);
}

} // namespace pointmill
