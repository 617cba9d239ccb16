// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
//
// pointmill_viewer: looks at scans, jobs and programs, and plays the cut.
// Exit codes: 0 good, 1 usage, 2 bad input, 130 after Ctrl-C.
#include "job_scene.h"
#include "progress/progress_line.h"
#include "progress/stop_on_signal.h"
#include "viewer_options.h"

#include "../options/pcl_look.h"

#include <pointmill/common/error.h>
#include <pointmill/common/version.h>
#include <pointmill/io/read_fields.h>
#include <pointmill/viewer/add_cloud.h>
#include <pointmill/viewer/viewer.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

using namespace pointmill;

namespace {

ViewerScene sceneOf(const ViewerOptions& options)
{
  ViewerScene scene;
  std::string directory;
  for (const auto& path : options.inputs)
    if (std::filesystem::is_directory(path)) {
      if (!directory.empty())
        throw ParameterError("pointmill_viewer: one job at a time, not " + directory +
                             " and " + path);
      directory = path;
    }
  if (directory.empty() && (!options.programs.empty() || !options.scan.empty()))
    throw ParameterError("pointmill_viewer: --program and --scan need the directory "
                         "of a job, which knows tools, stock and alignment");
  if (!directory.empty())
    scene = sceneOfJob(directory, options.programs);
  if (!options.scan.empty())
    addScan(scene, options.scan, directory);
  for (const auto& path : options.inputs)
    if (path != directory)
      addCloud(
          scene, std::filesystem::path(path).filename().string(), readScanFields(path));
  if (scene.title.empty())
    for (const auto& path : options.inputs)
      scene.title += (scene.title.empty() ? "" : ", ") +
                     std::filesystem::path(path).filename().string();
  return scene;
}

/// Makes what is to be shown; that may take a while.
std::unique_ptr<Viewer> viewerFor(const ViewerOptions& options)
{
  ViewerScene scene = sceneOf(options);
  const ViewerLook look = lookOf(options, scene);
  auto viewer = std::make_unique<Viewer>(std::move(scene), look);
  if (look.level && *look.level >= viewer->levels().size())
    throw ParameterError("pointmill_viewer: there is no level " +
                         std::to_string(*look.level + 1) + "; there are " +
                         std::to_string(viewer->levels().size()));
  return viewer;
}

void run(const ViewerOptions& options)
{
  std::unique_ptr<Viewer> viewer;
  {
    Watch watch;
    const StopOnSignal stop(watch);
    std::optional<ProgressLine> line;
    if (!options.quiet)
      line.emplace(watch);
    viewer = viewerFor(options);
  }
  if (options.screenshot.empty())
    viewer->show(options.width, options.height, options.play);
  else
    viewer->screenshot(options.screenshot, options.width, options.height);
}

} // namespace

int main(int argc, char** argv)
{
  CLI::App app{"Shows scans, jobs that pointmill has milled, and programs; plays the "
               "cut.\nMouse and keys are pcl_viewer's, with these beside them:\n\n" +
               Viewer::help()};
  app.set_version_flag("--version", std::string("pointmill_viewer ") + version);
  ViewerOptions options;
  declare(app, options);
  try {
    auto words = withTwoDashes(argc, argv, {"--ps", "--bc", "--ax"});
    app.parse(words);
    run(options);
  }
  catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) // --help, --version
      return app.exit(e);
    std::cerr << "pointmill_viewer: " << e.what() << " (pointmill_viewer --help)\n";
    return 1;
  }
  catch (const Interrupted& e) {
    std::cerr << "pointmill_viewer: " << e.what() << '\n';
    return interruptedExitCode();
  }
  catch (const ParameterError& e) {
    std::cerr << e.what() << '\n';
    return 1;
  }
  catch (const std::exception& e) {
    std::cerr << "pointmill_viewer: " << e.what() << '\n';
    return 2;
  }
  return 0;
}
