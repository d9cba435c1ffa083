// Bins, numbers in words, and pictures inside a page.
#include "report/charts.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "draw/chart/line_chart.hpp"
#include "report/html_text.hpp"

namespace blocks::report {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Bins, OfWholeNumbersAreAroundThem) {
  EXPECT_THAT(bin_boundaries({3, 5, 4, 4}), ElementsAre(2.5, 3.5, 4.5, 5.5));
  EXPECT_THAT(bin_boundaries({7, 7}), ElementsAre(6.5, 7.5));
}

TEST(Bins, CoverAllValuesWithRoundBoundaries) {
  std::vector<double> values;
  for (int i = 0; i < 500; ++i)
    values.push_back(std::sin(i) * 0.0123 + 0.5);
  const auto boundaries = bin_boundaries(values);
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  EXPECT_LE(boundaries.front(), *low);
  EXPECT_GE(boundaries.back(), *high);
  EXPECT_GE(boundaries.size(), 5U);
  EXPECT_LE(boundaries.size(), 90U);
  for (std::size_t i = 2; i < boundaries.size(); ++i)
    EXPECT_NEAR(boundaries[i] - boundaries[i - 1], boundaries[1] - boundaries[0],
                1e-12);
}

TEST(Bins, OfEqualValuesHaveAWidth) {
  const auto boundaries = bin_boundaries({-0.0011, -0.0011});
  EXPECT_LT(boundaries.front(), -0.0011);
  EXPECT_GT(boundaries.back(), -0.0011);
}

TEST(HtmlText, NumbersAreWrittenAsPeopleDo) {
  EXPECT_EQ(number_text(-0.25), "−0.2500");
  EXPECT_EQ(number_text(4036), "4036");
  EXPECT_EQ(number_text(1234567.8), "1.235×10⁶");
  EXPECT_EQ(number_text(1.5e-7), "1.500×10⁻⁷");
  EXPECT_EQ(number_text(no_number), "–");
  EXPECT_EQ(mean_text(-1.8477, {-1.8814, -1.8140}), "−1.848 ± 0.034");
  EXPECT_EQ(mean_text(2.4e5, {1.4e5, 3.4e5}), "(2.4 ± 1.0)×10⁵");
  EXPECT_EQ(interval_text({no_number, 2.0}), "… to 2");
  EXPECT_EQ(percent_text(0.9123), "91.2 %");
  EXPECT_EQ(percent_text(0.0001), "0.1 %");
}

TEST(HtmlText, WordsOfTheUserAreNotMarkup) {
  EXPECT_EQ(escaped("<b> & \"c\""), "&lt;b&gt; &amp; &quot;c&quot;");
  EXPECT_EQ(url_of("a b/ä#1.html"), "a%20b/%C3%A4%231.html");
  EXPECT_EQ(base64("Man"), "TWFu");
  EXPECT_EQ(base64("Ma"), "TWE=");
  EXPECT_EQ(base64("M"), "TQ==");
}

TEST(Chart, BarsAreCountedInWholeNumbers) {
  draw::ChartLine bars{"", {1.0, 2.0}, {2.0, 3.0}};
  bars.form = draw::ChartLine::Form::bars;
  bars.bar = 1.0;
  const draw::Chart chart{"", "", "x", {{"runs", {bars}}}};
  const std::string svg = draw::chart_svg(chart, draw::PageSize::in_print("118mm"));
  EXPECT_THAT(svg, HasSubstr(">runs</text>"));
  for (const char* tick : {">0</text>", ">1</text>", ">2</text>", ">3</text>"})
    EXPECT_THAT(svg, HasSubstr(tick));
  EXPECT_THAT(svg, HasSubstr(">0.5</text>")) << "the bars begin at x = 0.5";
  EXPECT_EQ(svg.find(">0.5</text>"), svg.rfind(">0.5</text>"));
}

// Two pictures on a page must not use each other's clips.
TEST(HtmlText, PicturesHaveTheirOwnIdentifiers) {
  EXPECT_EQ(
      unique_ids("<?xml?>\n<svg><g id=\"c\"/><use clip=\"url(#c)\" "
                 "xlink:href=\"#c\"/></svg>",
                 "f1-"),
      "<svg><g id=\"f1-c\"/><use clip=\"url(#f1-c)\" xlink:href=\"#f1-c\"/></svg>");
}

TEST(Chart, LegendThatIsTooLongForTheSideIsAboveThePanel) {
  const auto svg = [](const std::string& legend, const std::string& width) {
    draw::ChartLine points{legend, {0.2, 0.3}, {0.1, 0.5}, {0.0, 0.3}, {0.3, 0.7}};
    points.form = draw::ChartLine::Form::intervals;
    points.band_legend = "95 % interval (Wilson)";
    const draw::Chart chart{"", "", "x", {{"share of runs", {points}}}};
    return draw::chart_svg(chart, draw::PageSize::in_print(width));
  };
  const std::string words = "largest overlap, largest over time above 0.0002 L";
  for (const char* width : {"85mm", "175mm"}) {
    EXPECT_THAT(svg(words, width), HasSubstr(">" + words + "</text>")) << "is cut";
    EXPECT_THAT(svg(words, width), HasSubstr(">95 % interval (Wilson)</text>"));
  }
}

// A share used to be drawn against "FRICTN.fric", with "share" at the other axis.
TEST(Chart, AgainstAParameterNamesItsAxes) {
  Ensemble ensemble;
  ensemble.parameters = {"FRICTN.fric"};
  ensemble.columns = {{{}, "overlap above 0.1", "", true}};
  Analysis analysis;
  analysis.compared = 0;
  analysis.axis = {0.2, 0.4};
  for (const double share : {0.25, 0.5}) {
    ColumnStatistics column;
    column.summary.mean = share;
    column.interval = {share - 0.2, share + 0.2};
    analysis.groups.emplace_back().columns = {column};
  }
  draw::Chart chart = against_parameter(ensemble, analysis, 0);
  ASSERT_EQ(chart.panels.size(), 1U);
  EXPECT_EQ(chart.x_label, "coefficient of friction (FRICTN.fric)");
  EXPECT_EQ(chart.panels[0].y_label, "share of runs");
  const draw::ChartLine& points = chart.panels[0].lines.at(0);
  EXPECT_EQ(points.legend, "overlap above 0.1");
  EXPECT_EQ(points.band_legend, "95 % interval (Wilson)");
  EXPECT_THAT(points.low, ElementsAre(0.25 - 0.2, 0.5 - 0.2));
  ensemble.parameters = {"variant"};
  EXPECT_EQ(against_parameter(ensemble, analysis, 0).x_label, "variant");
}

// Short tick labels left a gap beside the label of the axis, a fifth of the width in
// all.
TEST(Chart, AxisInPrintIsAsWideAsItsTickLabels) {
  const auto left_edge = [](double low, double high) {
    draw::Chart chart;
    chart.panels = {{"mean [m]", {{"", {0, 1}, {low, high}}}}};
    const std::string svg = draw::chart_svg(chart, draw::PageSize::in_print("118mm"));
    std::smatch tick;
    const std::regex label(R"re(<text x="([0-9.]+)"[^>]*text-anchor="end")re");
    return std::regex_search(svg, tick, label) ? std::stod(tick[1]) : 0.0;
  };
  EXPECT_LT(left_edge(0, 2), 33.0) << "a tenth of the width";
  EXPECT_GT(left_edge(0, 200), left_edge(0, 20) + 3.0) << "a digit more";
  EXPECT_GT(left_edge(-0.02481, -0.02479), left_edge(0, 2) + 3.0);
}

}  // namespace
}  // namespace blocks::report
