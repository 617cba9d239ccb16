// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#pragma once

#include "../pointmill/option.h"

#include <pointmill/common/parameters.h>
#include <pointmill/common/report.h>
#include <pointmill/io/write_cloud.h>
#include <pointmill/viewer/viewer.h>

#include <pcl/PCLPointCloud2.h>
#include <pcl/conversions.h>

#include <chrono>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/// @brief A program round one stage, as PCL's tools are: input files, then an output
/// file, and an option for every parameter that the stage declares. It prints what went
/// in and came out, the seconds, and the stage's figures.
class Demo {
public:
  /// @param what the stage is, for the help
  /// @param example arguments
  Demo(const std::string& name, const std::string& what, const std::string& example);

  CLI::App& options() { return app_; }

  /// @brief A file that must be given.
  void input(const std::string& name, std::string& path, const std::string& help);

  /// @brief Where the result goes; may be left out where it is shown.
  /// @param ending of its name: what kind of file it is; empty: any
  void output(const std::string& name,
              const std::string& help,
              const std::string& ending = ".pcd");

  /// @brief An option that calls @p set with what one of a few names means; the first
  /// is what the stage does without it.
  template <typename Value>
  void choice(const std::string& option,
              const std::function<void(Value)>& set,
              const std::vector<std::pair<std::string, Value>>& choices,
              const std::string& help)
  {
    ::choice<Value>(app_, option, set, choices, help)
        ->default_str(choices.front().first);
  }
  /// @brief An option that takes one of the names in @p choices.
  template <typename Value>
  void oneOf(const std::string& option,
             std::string& name,
             const std::map<std::string, Value>& choices,
             const std::string& help);

  /// @brief Declares an option for every parameter of @p stage, which must outlive
  /// this; of several stages that have one of the same name it sets all.
  /// @param only where stages take turns, the name of this one, see use()
  template <typename StageT>
  void parameters(StageT& stage,
                  const std::string& stage_name,
                  const std::string& only = "");

  /// @brief Parses, runs @p body, and turns what is thrown into an exit code: 0 good, 1
  /// usage, 2 bad data, 3 refused.
  int run(int argc, char** argv, const std::function<void()>& body);
  /// @brief Of the stages that take turns, only these are used.
  /// @throws ParameterError where an option was given that none of them has
  void use(const std::vector<std::string>& chosen) const;

  /// @brief Whether an option was given.
  bool has(const std::string& option) const { return app_.count(option) > 0; }
  /// @brief Where the result goes; empty: nowhere.
  const std::string& output() const { return output_; }
  /// @brief The picture that is asked for, which finish() then does not make; empty:
  /// none.
  std::string takePng() { return std::exchange(png_, {}); }

  /// @brief Filters @p in, counts and times it, and prints the figures.
  template <typename StageT, typename CloudPtr>
  auto filter(StageT& stage, const CloudPtr& in) const;
  using Clock = std::chrono::steady_clock;
  /// @brief Prints points in and out, and the seconds since @p start.
  void printRun(std::size_t in, std::size_t out, Clock::time_point start) const;
  void print(const std::string& figure, const std::string& value) const;

  /// @brief Saves @p cloud, and shows it, as the options say.
  template <typename PointT>
  void finish(const pcl::PointCloud<PointT>& cloud);
  /// @brief The same of a text, with what it is about.
  template <typename PointT>
  void finish(const std::string& text, const pcl::PointCloud<PointT>& cloud);

private:
  using Set = std::function<void(double)>;
  struct Setter {
    std::string only;
    Set set;
  };
  void declare(const std::string& stage,
               const pointmill::ParameterValue& parameter,
               bool whole,
               Setter setter);
  std::vector<std::string> arguments(int argc, char** argv) const;
  void printReport(const pointmill::Report& report) const;
  template <typename PointT>
  void keep(const pcl::PointCloud<PointT>& cloud);
  void show() const;

  std::string name_, output_, png_;
  CLI::App app_;
  std::map<std::string, std::vector<Setter>> setters_; // by option
  pcl::PCLPointCloud2::Ptr shown_;                     // when all is done
  bool window_ = false, quiet_ = false;
  pointmill::ViewerLook look_; // pcl_viewer's options of it
};

template <typename Value>
void Demo::oneOf(const std::string& option,
                 std::string& name,
                 const std::map<std::string, Value>& choices,
                 const std::string& help)
{
  std::vector<std::pair<std::string, std::string>> names;
  for (const auto& choice : choices)
    names.emplace_back(choice.first, choice.first);
  ::choice(app_, option, name, names, help)->default_str(name);
}

template <typename StageT>
void Demo::parameters(StageT& stage,
                      const std::string& stage_name,
                      const std::string& only)
{
  stage.parameters([&](const char* name,
                       auto& value,
                       const char* unit,
                       pointmill::Range range,
                       const char* meaning) {
    using Value = std::decay_t<decltype(value)>;
    declare(stage_name,
            {name, static_cast<double>(value), unit, range, meaning},
            std::is_integral_v<Value>,
            {only, [&value](double given) { value = static_cast<Value>(given); }});
  });
}

template <typename StageT, typename CloudPtr>
auto Demo::filter(StageT& stage, const CloudPtr& in) const
{
  using Out = pcl::PointCloud<typename StageT::OutputPoint>;
  typename Out::Ptr out(new Out);
  stage.setInputCloud(in);
  const auto start = Clock::now();
  stage.filter(*out);
  printRun(in->size(), out->size(), start);
  printReport(stage.getReport());
  return out;
}

template <typename PointT>
void Demo::finish(const pcl::PointCloud<PointT>& cloud)
{
  if (!output_.empty())
    pointmill::writeCloud(output_, cloud);
  keep(cloud);
}

template <typename PointT>
void Demo::finish(const std::string& text, const pcl::PointCloud<PointT>& cloud)
{
  if (!output_.empty())
    pointmill::writeFileAtomically(output_, [&](std::ostream& out) { out << text; });
  keep(cloud);
}

template <typename PointT>
void Demo::keep(const pcl::PointCloud<PointT>& cloud)
{
  if (!window_ && png_.empty())
    return;
  shown_ = std::make_shared<pcl::PCLPointCloud2>();
  pcl::toPCLPointCloud2(cloud, *shown_);
}
