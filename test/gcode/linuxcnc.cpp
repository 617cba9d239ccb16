// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "linuxcnc.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace linuxcnc {

namespace {

namespace fs = std::filesystem;

std::string contents(const fs::path& path)
{
  std::ifstream in(path);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Runs the interpreter with a home of its own: it keeps tools there.
int run(const fs::path& folder, const std::string& program)
{
  std::ofstream(folder / "program.ngc") << program;
  // The reference points of G28 and G30, where no program goes by itself.
  std::ofstream parameters(folder / "parameters");
  for (const int first : {5161, 5181})
    for (int axis = 0; axis < 3; ++axis)
      parameters << first + axis << '\t' << 900.125 + 10 * axis + first % 7 << '\n';
  parameters.close();
  std::ofstream tools(folder / "tool.tbl");
  for (int t = 1; t <= 9; ++t)
    tools << "T" << t << " P" << t << " Z0 D10\n";
  tools.close();
  const std::string command = "cd '" + folder.string() +
                              "' && HOME=$PWD timeout 60 rs274 -g -n 2 -t tool.tbl "
                              "-v parameters program.ngc out </dev/null >log 2>&1";
  return std::system(command.c_str());
}

/// Follows the canonical calls.
class Listener {
public:
  explicit Listener(Judgement& result) : result_(result) {}

  void hear(const std::string& line)
  {
    const auto open = line.find('(');
    if (open == std::string::npos)
      return;
    const auto blank = line.rfind(' ', open);
    const std::string name = line.substr(blank + 1, open - blank - 1);
    const std::string rest = line.substr(open + 1);
    double n[6] = {};
    std::sscanf(rest.c_str(),
                "%lf, %lf, %lf, %lf, %lf, %lf",
                n,
                n + 1,
                n + 2,
                n + 3,
                n + 4,
                n + 5);
    if (name == "USE_LENGTH_UNITS")
      unit_ = rest.find("INCHES") == std::string::npos ? 1.0 : 25.4;
    else if (name == "SELECT_PLANE")
      selectPlane(rest);
    else if (name == "SET_FEED_RATE")
      feed_ = n[0] * unit_;
    else if (name == "SET_G92_OFFSET")
      shift_ = Eigen::Vector3d(n[0], n[1], n[2]) * unit_;
    else if (name == "SELECT_TOOL")
      result_.tools.push_back(static_cast<int>(n[0]));
    else if (name == "STRAIGHT_FEED" || name == "STRAIGHT_TRAVERSE")
      add(name == "STRAIGHT_TRAVERSE", Eigen::Vector3d(n[0], n[1], n[2]));
    else if (name == "ARC_FEED")
      addArc(n);
  }

private:
  void selectPlane(const std::string& name)
  {
    u_ = name.rfind("CANON_PLANE_XZ", 0) == 0   ? 2
         : name.rfind("CANON_PLANE_YZ", 0) == 0 ? 1
                                                : 0;
    v_ = (u_ + 1) % 3;
  }

  void add(bool rapid, const Eigen::Vector3d& to)
  {
    Call call;
    call.rapid = rapid;
    call.to = to * unit_ + shift_;
    call.feed = rapid ? 0.0 : feed_;
    call.rounding = 5.1e-5 * unit_;
    result_.calls.push_back(call);
  }

  /// End along both axes, centre along both, turning, end along the third.
  void addArc(const double (&n)[6])
  {
    Eigen::Vector3d to;
    const int w = 3 - u_ - v_;
    to[u_] = n[0];
    to[v_] = n[1];
    to[w] = n[5];
    add(false, to);
    Call& call = result_.calls.back();
    call.arc = true;
    call.u = u_;
    call.v = v_;
    call.w = w;
    call.centre =
        Eigen::Vector2d(n[2], n[3]) * unit_ + Eigen::Vector2d(shift_[u_], shift_[v_]);
    call.clockwise = n[4] < 0;
  }

  Judgement& result_;
  double unit_ = 1.0, feed_ = 0.0;
  int u_ = 0, v_ = 1;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
};

} // namespace

bool installed()
{
  return std::system("command -v rs274 >/dev/null 2>&1") == 0;
}

Judgement judge(const std::string& program)
{
  std::string name = (fs::temp_directory_path() / "pointmill-XXXXXX").string();
  const char* const made = mkdtemp(name.data());
  if (!made)
    throw std::runtime_error("no temporary directory");
  const fs::path folder = made;
  Judgement result;
  result.status = run(folder, program);
  result.text = contents(folder / "out");
  result.errors = contents(folder / "log");
  fs::remove_all(folder);

  Listener listener(result);
  std::istringstream lines(result.text);
  std::string line;
  while (std::getline(lines, line))
    listener.hear(line);
  return result;
}

} // namespace linuxcnc
