// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the PointMill authors
#include "checked_program.h"

#include "read_back.h"

#include <pointmill/common/error.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

using namespace pointmill;

namespace {

constexpr double kClearance = 5.0;  ///< over the stock [mm]
constexpr double kMostCells = 2000; ///< of the stock, along a side
constexpr double kOnTop = 1e-3;     ///< the part's top may be written so roughly [mm]
/// A thicker layer at once is told of, in diameters of the tool's end.
constexpr double kDeep = 1.5;

std::string number(double value)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << value;
  return out.str();
}

bool isLinked(const CLCloud& path)
{
  return std::any_of(path.begin(), path.end(), [](const PointCL& p) {
    return p.getMotion() == Motion::Rapid || p.getMotion() == Motion::Retract;
  });
}

double lowestOf(const CLCloud& path)
{
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& p : path)
    lowest = std::min<double>(lowest, p.z);
  return lowest;
}

} // namespace

Stock CheckedProgram::stockOver(const CLCloud& passes) const
{
  Stock stock;
  if (part) {
    stock = {part->min(), part->max()};
  }
  else {
    Eigen::AlignedBox3d box;
    for (const auto& p : passes)
      box.extend(p.getVector3fMap().cast<double>());
    const Eigen::Vector3d room(tool.radius(), tool.radius(), 0);
    stock = {box.min() - room, box.max() + room};
    if (std::isnan(stock_top))
      throw ParameterError(
          "without a part the block's height is not known: --stock-top");
  }
  if (!std::isnan(stock_top)) {
    if (part && stock_top < part->max().z() - kOnTop)
      throw ParameterError("--stock-top is Z" + number(stock_top) +
                           ", the part reaches up to Z" + number(part->max().z()) +
                           ": it does not fit into the block");
    stock.max.z() = stock_top;
  }
  stock.min.z() = std::min(stock.min.z(), lowestOf(passes) - 1.0);
  return stock;
}

CLCloud CheckedProgram::linkInto(const CLCloud& passes, const Stock& stock)
{
  const double longer = (stock.max - stock.min).head<2>().maxCoeff();
  const double cell = std::max(0.25, longer / kMostCells);
  using Field = StockField;
  link.setTool(tool);
  link.setCutting(cutting);
  link.setStock(std::make_shared<Field>(stock, cell, Field::Bound::Upper));
  link.setNominalStock(std::make_shared<Field>(stock, cell, Field::Bound::Nominal));
  if (part)
    link.setPart(part, 0.0, lowestOf(passes));
  link.setLowRapids(part != nullptr);
  link.setInputCloud(CLCloud::ConstPtr(new CLCloud(passes)));
  CLCloud path;
  link.filter(path);
  for (const auto& [name, value] : link.getReport().figures())
    figures.emplace_back("link_" + name, number(value));
  return path;
}

void CheckedProgram::write(const CLCloud& path, const Stock& stock)
{
  writer.setLowRapids(true); // LinkPasses proves them
  writer.setStock(stock);
  writer.addComment(part ? "verified against " + std::to_string(part->size()) +
                               " points of the part"
                         : "NOT VERIFIED AGAINST A PART");
  std::ostringstream out;
  out.imbue(std::locale::classic());
  const auto written = writer.write({{"passes", tool, cutting, path}}, out);
  text = out.str();
  figures.emplace_back("lines", std::to_string(written.lines));
}

Program CheckedProgram::readBack(const CLCloud& path) const
{
  GCodeReader reader;
  reader.setForm(writer.getPost().form);
  std::istringstream in(text);
  const Program program = reader.read(in);
  const std::string difference = differenceFrom(path, program, writer);
  if (!difference.empty())
    throw VerificationError("the program is not that of the CL points: " + difference);
  return program;
}

void CheckedProgram::verify(const Program& program, const Stock& stock)
{
  verifier.setPart(part);
  verifier.setStock(stock);
  verifier.setTools({tool});
  verifier.setFloor(stock.min.z());
  verifier.setAxialLimit(tool.number, kDeep * tool.endDiameter());
  verifier.setBlendLimit(writer.getPathTolerance() + 1e-9);
  const Verification result = verifier.verify(program);
  std::string errors;
  for (const auto& finding : result.findings)
    if (finding.severity == Severity::Error)
      errors += (errors.empty() ? "" : "; ") + finding.text;
    else
      figures.emplace_back("mind", finding.text);
  if (!result.good())
    throw VerificationError("the program is refused: " + errors);
  figures.emplace_back("gouge_mm", number(result.gouge));
}

CLCloud CheckedProgram::make(const CLCloud& passes)
{
  if (!part && !unverified)
    throw ParameterError("there is no part to verify the program against: give --part, "
                         "or --unverified to write it all the same");
  if (passes.empty())
    throw DataError("there are no CL points");
  tool.validate();
  const Stock stock = stockOver(passes);
  if (std::isnan(writer.getClearancePlane())) {
    writer.setClearancePlane(stock.top() + kClearance);
    link.setClearancePlane(stock.top() + kClearance);
  }
  figures.clear();
  const CLCloud path = isLinked(passes) ? passes : linkInto(passes, stock);
  if (path.empty())
    throw DataError("every pass would be entered straight down, which " +
                    tool.describe() + " cannot do");
  write(path, stock);
  const Program program = readBack(path);
  const std::size_t left_out = pointsLeftOut(passes, path);
  if (left_out > 0)
    figures.emplace_back("mind",
                         std::to_string(left_out) +
                             " CL points are left out: their passes would be entered "
                             "straight down");
  if (part)
    verify(program, stock);
  else
    figures.emplace_back("mind", "not verified against a part");
  return path;
}
