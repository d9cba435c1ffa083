// Draws the figures of docs/laws.md: law_figures FOLDER writes laws-*.svg. Each curve
// is one contact that is driven along a path, computed with the laws of the program.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "draw/chart/line_chart.hpp"
#include "validation/laws/one_contact.hpp"

namespace blocks::validation {
namespace {

using draw::Chart;
using draw::ChartLine;
using draw::ChartPanel;

constexpr double kN = 1e3;

/// Draws a chart in place of an older one.
void draw(const std::string& path, const Chart& chart) {
  std::filesystem::remove(path);
  draw_chart(path, chart, draw::PageSize());
}

/// What a direct shear test at a constant normal stress records.
struct ShearTest {
  ChartLine stress, opening;
};

/// Slides a joint of 1 m in steps of 1 um to each of the turning points [mm].
ShearTest shear(OneContact contact, const std::string& name, double normal_stress,
                const std::vector<double>& turning_points, double stress_unit) {
  ShearTest test = {{name, {}, {}}, {name, {}, {}}};
  double at = 0.0;
  const auto record = [&] {
    test.stress.x.push_back(at / mm), test.opening.x.push_back(at / mm);
    test.stress.y.push_back(contact.force.shear / stress_unit);
    test.opening.y.push_back(contact.state.offset / mm);
  };
  slide(contact, normal_stress, 0.0, 1);
  record();
  constexpr double step = 1e-3 * mm;
  for (const double end : turning_points) {
    const double sign = end * mm > at ? 1.0 : -1.0;
    const int steps = static_cast<int>(std::lround(std::abs(end * mm - at) / step));
    for (int i = 0; i < steps; ++i) {
      slide(contact, normal_stress, sign * step, 1);
      at += sign * step;
      if (i % 50 == 0 || at < 0.13 * mm || i + 1 == steps)  // the peak is at 0.12 mm
        record();
    }
  }
  return test;
}

void draw_shear(const std::string& folder) {
  OneContact coulomb = bonded_joint(1 * MN);
  coulomb.law.dilation = std::tan(10 * degree), coulomb.law.dilation_limit = 5 * mm;
  OneContact barton = rough_joint(10 * GPa);
  load(barton, 1 * MN);
  const std::vector<double> there_and_back = {8.0, 0.0};
  const ShearTest a = shear(coulomb, "Mohr-Coulomb", 1 * MN, there_and_back, MPa);
  const ShearTest b = shear(barton, "Barton-Bandis", 1 * MN, there_and_back, MPa);
  Chart chart{"Direct shear of a joint at a normal stress of 1 MPa",
              "sheared by 8 mm and back",
              "shear displacement [mm]",
              {{"shear stress [MPa]", {a.stress, b.stress}},
               {"opening by dilation [mm]", {a.opening, b.opening}}}};
  draw(folder + "/laws-shear.svg", chart);
}

void draw_barton(const std::string& folder) {
  ChartPanel strength{"shear stress / normal stress", {}};
  ChartPanel opening{"opening by dilation [mm]", {}};
  for (const double stress : {0.1, 1.0, 10.0, 100.0}) {
    OneContact contact = rough_joint(1000 * GPa);
    load(contact, stress * MN);
    const ShearTest test = shear(contact, fmt::format("{:g} MPa", stress), stress * MN,
                                 {20.0}, stress * MPa);
    strength.lines.push_back(test.stress), opening.lines.push_back(test.opening);
  }
  Chart chart{"Roughness of Barton-Bandis at four normal stresses",
              "JRC 10, JCS 100 MPa, residual angle 30 degrees, peak slip 4.28 mm",
              "shear displacement [mm]",
              {strength, opening}};
  draw(folder + "/laws-barton.svg", chart);
}

void draw_walton(const std::string& folder) {
  OneContact contact(Kind::walton, 2e8, 0.0);
  contact.law.unloading_ratio = 1.0 / (0.5 * 0.5);
  ChartLine first{"line of first loading", {0.0, 4.0}, {0.0, 2e8 * 4 * mm / kN}};
  ChartLine path{"path of a contact", {}, {}};
  double at = 0.0;
  for (const double end : {2.0, 1.2, 3.2, 2.2, 2.6, 2.0}) {
    const int steps = 200;
    const double step = (end * mm - at) / steps;
    for (int i = 0; i < steps; ++i) {
      contact.move(step, 0.0);
      at += step;
      path.x.push_back(at / mm), path.y.push_back(contact.force.normal / kN);
    }
  }
  Chart chart{"Walton's normal force",
              "K1 = 200 kN/mm, e = 0.5, so K2 = 800 kN/mm",
              "sum of the closing a [mm]",
              {{"normal force [kN]", {first, path}}}};
  draw(folder + "/laws-walton.svg", chart);
}

void draw_bandis(const std::string& folder) {
  OneContact contact = rough_joint(0.0);
  const BandisClosure<double> bandis(contact.law, 1.0, contact.state.stiffness);
  ChartLine stress{"closure", {}, {}}, tangent{"tangent", {}, {}};
  constexpr double step = 2e-4 * mm;
  for (int i = 0; i < 960; ++i) {
    const double before = contact.state.normal;
    contact.move(step, 0.0);
    stress.x.push_back((i + 1) * step / mm);
    stress.y.push_back(contact.state.normal / MPa);
    tangent.x.push_back((i + 0.5) * step / mm);
    tangent.y.push_back((contact.state.normal - before) / step / GPa);
  }
  ChartLine edge{"tangent reaches knmax", {bandis.linear_from / mm}, {0.0}};
  edge.form = ChartLine::Form::mark;
  Chart chart{"Normal closure of Bandis",
              "kni = 10 GPa/m, vm = 0.2 mm, knmax = 1000 GPa/m",
              "closure V [mm]",
              {{"normal stress [MPa]", {stress, edge}},
               {"tangent stiffness [GPa/m]", {tangent, edge}}}};
  draw(folder + "/laws-bandis.svg", chart);
}

}  // namespace
}  // namespace blocks::validation

int main(int count, char** arguments) {
  using namespace blocks::validation;
  if (count != 2) {
    std::fputs("usage: law_figures FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::string folder = arguments[1];
    draw_shear(folder);
    draw_barton(folder);
    draw_walton(folder);
    draw_bandis(folder);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "law_figures: %s\n", error.what());
    return 1;
  }
  return 0;
}
