// Figures and the quantities that they show.
#include "post/figure/figure.hpp"

#include <cairo.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <regex>

#include "draw/axes.hpp"
#include "draw/page_file.hpp"
#include "draw/pen.hpp"
#include "files/file_error.hpp"
#include "files/whole_file.hpp"
#include "post/figure/two_squares.hpp"
#include "post/read/frame_quantity.hpp"

namespace blocks::post {

using namespace draw;

namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::Gt;
using ::testing::HasSubstr;
using ::testing::Lt;
using ::testing::Not;

TEST(Figure, PaintsBlocksInTheColourOfTheirMaterial) {
  const Folder folder;
  const std::string path = folder.file("a.png");
  FigureOptions options;
  options.zoom = Eigen::Vector4d(0, 2, 0, 2);
  draw_frame(path, two_squares(), two_squares(), "two squares", options);
  cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
  ASSERT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(cairo_image_surface_get_width(image), 1200);
  const Axes axes({0, 2, 0, 2}, 84, 78, 966);  // This is the place of a single picture.
  const int x = static_cast<int>(axes.x(0.4)), y = static_cast<int>(axes.y(0.4));
  const unsigned char* pixel = cairo_image_surface_get_data(image) +
                               y * cairo_image_surface_get_stride(image) + 4 * x;
  const Colour expected = material_colour(1);
  EXPECT_NEAR(pixel[2], 255 * expected.r, 2);
  EXPECT_NEAR(pixel[1], 255 * expected.g, 2);
  EXPECT_NEAR(pixel[0], 255 * expected.b, 2);
  cairo_surface_destroy(image);
}

/// Returns how many pixels of a PNG file have this colour.
int pixels_of(const std::string& path, const Colour& wanted) {
  cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
  EXPECT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  int pixels = 0;
  for (int y = 0; y < cairo_image_surface_get_height(image); ++y)
    for (int x = 0; x < cairo_image_surface_get_width(image); ++x) {
      const unsigned char* at = cairo_image_surface_get_data(image) +
                                y * cairo_image_surface_get_stride(image) + 4 * x;
      pixels += std::abs(at[2] - 255 * wanted.r) < 2 &&
                std::abs(at[1] - 255 * wanted.g) < 2 &&
                std::abs(at[0] - 255 * wanted.b) < 2;
    }
  cairo_surface_destroy(image);
  return pixels;
}

TEST(Mark, LeavesTheColourOfTheMaterial) {
  const Folder folder;
  const std::string plain = folder.file("plain.png"),
                    marked = folder.file("marked.png");
  Frame frame = two_squares();
  frame.fixed = {0, 0};
  FigureOptions options;
  draw_frame(plain, frame, frame, "two squares", options);
  options.marks = {{Mark::Kind::slender, {0.5, 0.5}, {}, {0, 1}}};
  draw_frame(marked, frame, frame, "two squares", options);
  const Colour material = material_colour(1);
  EXPECT_GT(pixels_of(marked, material), 0.8 * pixels_of(plain, material));
  const Colour warning = mark_colour(Mark::Kind::slender);
  EXPECT_GT(pixels_of(marked, warning), 1000);
}

// A block moves to the right, so its mirror image moves to the left.
TEST(Figure, ReversesVectorsInTheMirrorImage) {
  const Folder folder;
  const std::string path = folder.file("mirror.png");
  Frame frame = two_squares();
  frame.fixed = {0, 0};
  FigureOptions options;
  options.colour = "VELX";
  options.mirror = true;
  options.zoom = Eigen::Vector4d(-2, 2, -2, 2);
  options.range = Eigen::Vector2d(-4, 4);
  draw_frame(path, frame, frame, "a half model", options);
  const int right = pixels_of(path, diverging(7.0 / 8)),
            left = pixels_of(path, diverging(1.0 / 8));
  EXPECT_GT(left, 10000);
  EXPECT_NEAR(left, right, 0.02 * right);
}

// Zoom cut arrows anywhere, so that some had no head.
TEST(Figure, AnArrowThatLeavesThePictureEndsAtItsFrameWithAnOpenHead) {
  const Folder folder;
  const std::string path = folder.file("arrow.png");
  Frame frame = two_squares();
  frame.fixed = {0, 0};
  frame.velocity << 1, 0, 0, 0;
  FigureOptions options;
  options.arrows = "velocity";
  options.zoom = Eigen::Vector4d(0.1, 0.52, 0.3, 0.72);  // the block goes on beyond it
  draw_frame(path, frame, frame, "two squares", options);
  cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
  ASSERT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  const Axes axes(*options.zoom, 84, 78, 966);
  const auto colour_at = [&](double x) {
    const unsigned char* pixel =
        cairo_image_surface_get_data(image) +
        static_cast<int>(axes.y(0.5)) * cairo_image_surface_get_stride(image) +
        4 * static_cast<int>(x);
    return std::array<int, 3>{pixel[2], pixel[1], pixel[0]};
  };
  constexpr double to_frame = 2, head = 9;
  EXPECT_THAT(colour_at(axes.right() - to_frame - 0.6 * head), Each(Gt(240)));
  EXPECT_THAT(colour_at(axes.right() - to_frame - 2.0 * head), Each(Lt(130)));
  cairo_surface_destroy(image);
}

/// Returns a figure of the two squares in print, one column wide.
std::string in_print(FigureOptions options) {
  const Folder folder;
  const Frame frame = two_squares();
  options.page = PageSize::in_print("85mm");
  draw_frame(folder.file("a.svg"), frame, frame, "two squares", options);
  return content(folder.file("a.svg"));
}

// A caption says what the lines above a figure in print would say.
TEST(Figure, InPrintWithoutATitleHasNoLineOfTimeAndStep) {
  FigureOptions options;
  EXPECT_THAT(in_print(options), HasSubstr("step 0"));
  options.requested_times = {1.43};
  EXPECT_THAT(in_print(options), HasSubstr(">t = 0    step"))
      << "the time asked for is printed on the terminal";
  options.title = "";
  EXPECT_THAT(in_print(options), Not(HasSubstr("step 0")));
  options.subtitle = "after a second";
  EXPECT_THAT(in_print(options), HasSubstr(">after a second<"));
}

// The axis took a fifth of the width, whatever its numbers were.
TEST(Figure, InPrintHasNoMoreRoomForNumbersThanTheyNeed) {
  const auto end_of_numbers = [](const std::string& svg) {
    std::smatch found;
    const std::regex number(R"re(<text x="([0-9.]+)"[^>]*text-anchor="end")re");
    return std::regex_search(svg, found, number) ? std::stod(found[1]) : 0.0;
  };
  FigureOptions options;
  const double low = end_of_numbers(in_print(options));
  options.zoom = Eigen::Vector4d(0, 40, 8000, 8020);
  EXPECT_GT(end_of_numbers(in_print(options)), low + 5.0);
}

// The offset of y was printed over the line of time and step, and x had none.
TEST(Figure, BothAxesNameTheirOffsetsInNationalCoordinates) {
  FigureOptions options;
  options.zoom = Eigen::Vector4d(349999.7, 350010.3, 5599998.7, 5600005.3);
  const std::string svg = in_print(options);
  EXPECT_THAT(svg, HasSubstr(">x − 350000 [L]<"));
  EXPECT_THAT(svg, HasSubstr(">y − 5600000 [L]<"));
  EXPECT_THAT(svg, Not(HasSubstr("+5600000")));
  options.zoom = Eigen::Vector4d(0, 10, 5599998.7, 5600005.3);
  EXPECT_THAT(in_print(options), HasSubstr(">x [L]<"));
}

TEST(Figure, LastNumberOfTheAxisDoesNotTouchTheEdge) {
  FigureOptions options;
  options.zoom = Eigen::Vector4d(0, 4000, 0, 2000);
  const std::string svg = in_print(options);
  std::smatch width, number;
  ASSERT_TRUE(std::regex_search(svg, width, std::regex(R"re(width="([0-9.]+)pt")re")));
  const std::regex last(
      R"re(<text x="([0-9.]+)"[^>]*text-anchor="middle"[^>]*>4000<)re");
  ASSERT_TRUE(std::regex_search(svg, number, last)) << svg;
  constexpr double half_of_number = 8.9;  // four digits of 7 pt
  EXPECT_LT(std::stod(number[1]) + half_of_number, std::stod(width[1]) - 1.5);
}

TEST(Figure, LeavesNoTemporaryFileOfVectorFormats) {
  const Folder folder;
  for (const char* name : {"a.svg", "a.pdf"}) {
    draw_frame(folder.file(name), two_squares(), two_squares(), "", {});
    EXPECT_GT(content(folder.file(name)).size(), 1000U);
    EXPECT_FALSE(std::filesystem::exists(folder.file(name) + ".tmp"));
  }
}

// The chunk pHYs holds 11811 dots per metre, which are 300 dots per inch.
TEST(Figure, InPrintHasItsPhysicalSizeAsPng) {
  const Folder folder;
  const std::string path = folder.file("print.png");
  FigureOptions options;
  options.page = PageSize::in_print("85mmx60mm");
  draw_frame(path, two_squares(), two_squares(), "two squares", options);
  cairo_surface_t* image = cairo_image_surface_create_from_png(path.c_str());
  ASSERT_EQ(cairo_surface_status(image), CAIRO_STATUS_SUCCESS);
  EXPECT_EQ(cairo_image_surface_get_width(image), 1004);
  EXPECT_EQ(cairo_image_surface_get_height(image), 709);
  cairo_surface_destroy(image);
  const std::string bytes = content(path), dots{"\0\0\x2e\x23", 4};
  EXPECT_THAT(bytes, HasSubstr("pHYs" + dots + dots + '\1'));
}

TEST(Figure, InPrintHasItsPhysicalSizeAsSvg) {
  const Folder folder;
  FigureOptions options;
  options.page = PageSize::in_print("3.5in");
  draw_frame(folder.file("a.svg"), two_squares(), two_squares(), "", options);
  EXPECT_THAT(content(folder.file("a.svg")), HasSubstr("width=\"252pt\""));
}

/// Returns the contents of an SVG file of the two squares and their numbers.
std::string svg_of_two_squares(FigureOptions options) {
  const Folder folder;
  options.numbers = true;
  draw_frame(folder.file("a.svg"), two_squares(), two_squares(), "squares & <blocks>",
             options);
  return content(folder.file("a.svg"));
}

TEST(Figure, HasTextElementsInSvg) {
  const std::string svg = svg_of_two_squares({});
  EXPECT_THAT(svg, HasSubstr(">squares &amp; &lt;blocks&gt;</text>"));
  EXPECT_THAT(svg, HasSubstr(">2</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("<symbol")));  // the outlines of letters
}

TEST(Figure, InPrintListsManyMaterialsBelowTheJoints) {
  const Folder folder;
  const std::string path = folder.file("a.svg");
  Frame frame = two_squares();
  frame.centroid = Eigen::Matrix2Xd::Zero(2, 12);
  for (int material = 3; material <= 12; ++material) {
    frame.outlines.push_back(frame.outlines.front());
    frame.number.push_back(material);
    frame.material.push_back(material);
    frame.fixed.push_back(0);
  }
  frame.joints.assign(12, {1, 1, 1, 1});
  FigureOptions options;
  options.page = PageSize::in_print("85mm");
  options.colour = "joint";
  draw_frame(path, frame, frame, "", options);
  const std::string svg = content(path);
  const auto height_of = [&](const std::string& words) {
    std::smatch found;
    EXPECT_TRUE(std::regex_search(svg, found,
                                  std::regex(" y=\"([0-9.]+)\"[^>]*>" + words + "<")));
    return std::stod(found[1]);
  };
  EXPECT_GT(height_of("materials"), height_of("no joint") + 8);
  EXPECT_GT(height_of("fixed"), height_of("12") + 4);
}

TEST(Figure, LeavesOutNumbersOutsideTheZoomInSvg) {
  FigureOptions options;
  options.zoom = Eigen::Vector4d(1.2, 1.3, 0.2, 0.3);  // The centroid is not inside.
  EXPECT_THAT(svg_of_two_squares(options), Not(HasSubstr(">2</text>")));
}

TEST(Figure, HasAWhiteBackgroundAndTrueMinusSigns) {
  FigureOptions options;
  options.zoom = Eigen::Vector4d(-2, 2, -2, 2);
  const std::string svg = svg_of_two_squares(options);
  EXPECT_THAT(svg, HasSubstr(">−1</text>"));
  EXPECT_THAT(svg, Not(HasSubstr(">-1</text>")));
  EXPECT_THAT(svg, Not(HasSubstr("99.2")));  // no tint
}

TEST(Figure, HasTextOf7To9PointsInPrintForEveryWidth) {
  for (const char* size : {"single", "double", "60mm", "400mm"}) {
    FigureOptions options;
    options.page = PageSize::in_print(size);
    options.colour = "vx";
    const std::string svg = svg_of_two_squares(options);
    const std::regex letters("font-size=\"([0-9.]+)\"");
    int lines = 0;
    for (std::sregex_iterator at(svg.begin(), svg.end(), letters), end; at != end;
         ++at) {
      const double points = std::stod((*at)[1]);
      EXPECT_GE(points, 6.99) << size;
      EXPECT_LE(points, 9.01) << size;
      ++lines;
    }
    EXPECT_GT(lines, 10) << size;
  }
}

TEST(Figure, InPrintIsRefusedIfTheSizeHasNoRoomForThePicture) {
  const Folder folder;
  FigureOptions options;
  options.page = PageSize::in_print("30mm");
  EXPECT_THROW(
      draw_frame(folder.file("a.png"), two_squares(), two_squares(), "", options),
      std::runtime_error);
}

TEST(Figure, CannotBeWrittenIntoAMissingFolder) {
  const Folder folder;
  EXPECT_THROW(
      draw_frame(folder.file("none/a.png"), two_squares(), two_squares(), "", {}),
      std::runtime_error);
}

TEST(Figure, DoesNotReplaceAFifo) {
  const Folder folder;
  const std::string fifo = folder.file("p.svg");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_THROW(write_page(fifo, 10, 10, [](cairo_t*) {}), files::FileError);
  EXPECT_THROW(files::WholeFile{fifo}, files::FileError);
  EXPECT_TRUE(std::filesystem::is_fifo(fifo));
}

TEST(Figure, NamesTheFormatsIfOneIsUnknown) {
  const Folder folder;
  try {
    draw_frame(folder.file("a.bmp"), two_squares(), two_squares(), "", {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr(".png, .svg or .pdf"));
  }
}

TEST(Figure, NamesTheQuantitiesIfOneIsUnknown) {
  const Folder folder;
  FigureOptions options;
  options.colour = "heat";
  try {
    draw_frame(folder.file("a.png"), two_squares(), two_squares(), "", options);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("speed, displacement, rotation"));
  }
}

// The principal stresses of (3, 1; 1, 3) are 4 and 2. The speed of (3, 4) is 5.
TEST(Quantity, FollowsItsDefinition) {
  const Frame frame = two_squares();
  EXPECT_DOUBLE_EQ(quantity("speed", frame, frame).values[0], 5.0);
  EXPECT_DOUBLE_EQ(quantity("p1", frame, frame).values[0], 4.0);
  EXPECT_DOUBLE_EQ(quantity("p2", frame, frame).values[0], 2.0);
  EXPECT_DOUBLE_EQ(quantity("displacement", frame, frame).values[1], 0.0);
}

TEST(Quantity, OfStressSaysWhichSignIsPositive) {
  Frame frame = two_squares();
  EXPECT_EQ(quantity("s11", frame, frame).label, "stress 11, tension positive");
  frame.compression_positive = true;
  EXPECT_EQ(quantity("SIGYY", frame, frame).label, "stress 22, compression positive");
  EXPECT_EQ(quantity("speed", frame, frame).label, "speed");
}

TEST(Figure, RefusesStressThatIsZeroEverywhere) {
  const Folder folder;
  Frame rigid = two_squares();
  rigid.stress.setZero();
  FigureOptions options;
  options.colour = "s11";
  try {
    draw_frame(folder.file("a.png"), rigid, rigid, "", options);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("RIGID blocks have no stress"));
  }
}

}  // namespace
}  // namespace blocks::post
