// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "demo.h"

#include "../options/pcl_look.h"
#include "progress/progress_line.h"
#include "progress/stop_on_signal.h"

#include <pointmill/common/error.h>
#include <pointmill/common/nearest_name.h>
#include <pointmill/viewer/add_cloud.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <optional>

using namespace pointmill;

namespace {

std::string text(double value)
{
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.6g", value);
  return buffer;
}

/// "cell_size" is --cell-size.
std::string optionOf(std::string parameter)
{
  std::replace(parameter.begin(), parameter.end(), '_', '-');
  return "--" + parameter;
}

/// No file is named as another kind than it is.
std::function<std::string(const std::string&)> endsIn(const std::string& ending)
{
  return [ending](const std::string& file) {
    const std::string is = std::filesystem::path(file).extension().string();
    return is == ending ? std::string() : file + ": it is written as " + ending;
  };
}

} // namespace

Demo::Demo(const std::string& name, const std::string& what, const std::string& example)
    : name_(name), app_(what, name)
{
  app_.footer("Example:\n  " + name + " " + example);
  app_.get_formatter()->column_width(36);
  const char* const group = "Showing";
  app_.add_flag("-q,--quiet", quiet_, "print nothing but errors");
  app_.add_flag("--show", window_, "in a window with pcl_viewer's keys")->group(group);
  app_.add_option("--png", png_, "save a picture of the result")
      ->type_name("FILE")
      ->check(endsIn(".png"))
      ->group(group);
  look_.point_size = 2;
  declarePclLook(app_, look_, group);
}

void Demo::input(const std::string& name, std::string& path, const std::string& help)
{
  app_.add_option(name, path, help)->required();
}

void Demo::output(const std::string& name,
                  const std::string& help,
                  const std::string& ending)
{
  auto* option =
      app_.add_option(name, output_, help + "; may be left out with --show or --png");
  if (!ending.empty())
    option->check(endsIn(ending));
}

void Demo::declare(const std::string& stage,
                   const ParameterValue& parameter,
                   bool whole,
                   Setter setter)
{
  const std::string option = optionOf(parameter.name);
  const auto set = std::move(setter.set);
  setter.set = [=](double value) {
    checkRange(stage, option, value, parameter.unit, parameter.range);
    if (whole && value != std::floor(value))
      throw ParameterError(stage + ": " + option + " is " + text(value) +
                           "; it must be a whole number");
    set(value);
  };
  auto& setters = setters_[option];
  setters.push_back(std::move(setter));
  if (setters.size() > 1)
    return;
  app_.add_option_function<double>(
          option,
          [&setters](double value) {
            for (const Setter& s : setters)
              s.set(value);
          },
          parameter.meaning + ", " + text(parameter.range.low) + " .. " +
              text(parameter.range.high))
      ->type_name(parameter.unit.empty() ? "N" : parameter.unit)
      ->default_str(std::isnan(parameter.value) ? "" : text(parameter.value))
      ->group("Parameters of " + stage);
}

std::vector<std::string> Demo::arguments(int argc, char** argv) const
{
  std::vector<std::string> known;
  for (const CLI::Option* option : app_.get_options())
    for (const std::string& name : option->get_lnames())
      known.push_back("--" + name);
  const auto given = withTwoDashes(argc, argv, known);
  for (const std::string& word : given) {
    const std::string name = word.substr(0, word.find('='));
    if (name.size() > 2 && name.compare(0, 2, "--") == 0 &&
        std::find(known.begin(), known.end(), name) == known.end())
      throw ParameterError("unknown option " + name + "; did you mean " +
                           nearestName(name, known) + "?");
  }
  return given;
}

void Demo::use(const std::vector<std::string>& chosen) const
{
  std::string names;
  for (const std::string& name : chosen)
    names += (names.empty() ? "" : " and ") + name;
  for (const auto& [option, setters] : setters_) {
    const bool befits =
        std::any_of(setters.begin(), setters.end(), [&](const Setter& s) {
          return s.only.empty() ||
                 std::find(chosen.begin(), chosen.end(), s.only) != chosen.end();
        });
    if (!befits && has(option))
      throw ParameterError(option + " does not befit " + names);
  }
}

int Demo::run(int argc, char** argv, const std::function<void()>& body)
{
  const auto fail = [&](const std::string& why, int code) {
    std::cerr << name_ << ": " << why << '\n';
    return code;
  };
  const std::string help = " (" + name_ + " --help)";
  try {
    app_.parse(arguments(argc, argv));
    if (output_.empty() && png_.empty() && !window_)
      throw ParameterError("name a file for the result, or --show or --png");
    {
      Watch watch;
      const StopOnSignal stop(watch);
      std::optional<ProgressLine> line;
      if (!quiet_)
        line.emplace(watch);
      body();
    }
    show();
  }
  catch (const CLI::ParseError& e) {
    return e.get_exit_code() == 0 ? app_.exit(e) : fail(e.what() + help, 1);
  }
  catch (const Interrupted& e) {
    return fail(e.what(), interruptedExitCode());
  }
  catch (const VerificationError& e) {
    return fail(e.what(), 3);
  }
  catch (const ParameterError& e) {
    return fail(e.what() + help, 1);
  }
  catch (const std::exception& e) {
    return fail(e.what(), 2);
  }
  return 0;
}

void Demo::print(const std::string& figure, const std::string& value) const
{
  if (!quiet_)
    std::cout << "  " << figure << ' ' << value << '\n';
}

void Demo::printRun(std::size_t in, std::size_t out, Clock::time_point start) const
{
  const std::chrono::duration<double> took = Clock::now() - start;
  if (!quiet_)
    std::cout << name_ << ": " << in << " points in, " << out << " points out, "
              << text(std::round(1000 * took.count()) / 1000) << " s\n";
}

void Demo::printReport(const Report& report) const
{
  for (const auto& [figure, value] : report.figures())
    print(figure, text(value));
}

void Demo::show() const
{
  if (!shown_)
    return;
  const std::string file = std::filesystem::path(output_).filename().string();
  ViewerScene scene;
  scene.title = name_ + (file.empty() ? "" : " - " + file);
  addCloud(scene, scene.title, shown_);
  ViewerLook look = lookFor(scene);
  takePclLook(look_, look);
  Viewer viewer(std::move(scene), look);
  constexpr int width = 1200, height = 900;
  if (!png_.empty())
    viewer.screenshot(png_, width, height);
  if (window_)
    viewer.show(width, height);
}
