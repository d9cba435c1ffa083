#include "draw/page_file.hpp"

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "draw/png_resolution.hpp"
#include "draw/svg_text.hpp"
#include "files/file_tools.hpp"

namespace blocks::draw {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;
using Draw = std::function<void(cairo_t*)>;

/// What cairo cannot draw.
struct CairoFault : std::runtime_error {
  explicit CairoFault(const char* reason)
      : std::runtime_error(std::string("cannot draw a figure: ") + reason),
        why(reason) {}
  const char* why;
};

void expect_sound(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw CairoFault(cairo_status_to_string(status));
}

/// Appends bytes to a text, as cairo's streams need it.
cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

/// Returns a page as a file with this ending. A unit of `draw` has `scale` pixels
/// (PNG); SVG and PDF have points. Throws CairoFault.
std::string page_bytes(const std::string& ending, const PageSize& page, double height,
                       double scale, const Draw& draw) {
  const double wide = page.unit * page.width * scale, high = page.unit * height * scale;
  const auto pixels = [](double size) { return static_cast<int>(std::ceil(size)); };
  std::string bytes;
  const Surface surface(
      ending == ".svg" ? cairo_svg_surface_create_for_stream(append, &bytes, wide, high)
      : ending == ".pdf"
          ? cairo_pdf_surface_create_for_stream(append, &bytes, wide, high)
          : cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(wide), pixels(high)),
      cairo_surface_destroy);
  expect_sound(cairo_surface_status(surface.get()));
  std::optional<SvgText> text;
  if (ending == ".svg")
    text.emplace(surface.get());
  {
    const Context pen(cairo_create(surface.get()), cairo_destroy);
    cairo_scale(pen.get(), scale, scale);
    draw(pen.get());
    cairo_show_page(pen.get());
  }
  if (ending == ".png")
    expect_sound(cairo_surface_write_to_png_stream(surface.get(), append, &bytes));
  cairo_surface_finish(surface.get());
  expect_sound(cairo_surface_status(surface.get()));
  return text ? text->inserted(std::move(bytes)) : bytes;
}

}  // namespace

void write_page(const std::string& path, double width, double height,
                const Draw& draw) {
  PageSize page;
  page.width = width;
  write_page(path, page, height, draw);
}

void write_page(const std::string& path, const PageSize& page, double height,
                const Draw& draw) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".png" && ending != ".svg" && ending != ".pdf")
    throw std::runtime_error(
        "the figure's name must end in .png, .svg or .pdf, found '" + path + "'");
  constexpr double points_per_inch = 72.0;
  const bool is_scaled = ending == ".png" && page.printed;
  try {
    const std::string bytes =
        page_bytes(ending, page, height,
                   is_scaled ? page.resolution() / points_per_inch : 1.0, draw);
    files::replace_file_keeping_older(
        path, is_scaled ? with_resolution(bytes, page.resolution()) : bytes);
  } catch (const CairoFault& fault) {
    throw files::FileError("cannot write " + path + ": " + fault.why);
  }
}

std::string svg_page(const PageSize& page, double height, const Draw& draw) {
  return page_bytes(".svg", page, height, 1.0, draw);
}

std::string png_page(const PageSize& page, double height, const Draw& draw) {
  constexpr double pixels_per_point = 2.0;  // for screens of high resolution
  return page_bytes(".png", page, height, page.printed ? pixels_per_point : 1.0, draw);
}

}  // namespace blocks::draw
