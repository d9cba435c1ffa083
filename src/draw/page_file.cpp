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
#include "output/file_tools.hpp"

namespace blocks::draw {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Pen = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

[[noreturn]] void cannot_write(const std::string& path, const std::string& why) {
  throw output::FileError("cannot write " + path + ": " + why);
}

/// Appends bytes to a text, as cairo's streams need it.
cairo_status_t append(void* text, const unsigned char* data, unsigned int size) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), size);
  return CAIRO_STATUS_SUCCESS;
}

void draw_on(cairo_surface_t* surface, double scale,
             const std::function<void(cairo_t*)>& draw) {
  const Pen pen(cairo_create(surface), cairo_destroy);
  cairo_scale(pen.get(), scale, scale);
  draw(pen.get());
  cairo_show_page(pen.get());
}

void expect_drawn(cairo_surface_t* surface) {
  if (const auto status = cairo_surface_status(surface); status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("cannot draw a figure: ") +
                             cairo_status_to_string(status));
}

}  // namespace

void write_page(const std::string& path, double width, double height,
                const std::function<void(cairo_t*)>& draw) {
  PageSize page;
  page.width = width;
  write_page(path, page, height, draw);
}

void write_page(const std::string& path, const PageSize& page, double page_height,
                const std::function<void(cairo_t*)>& draw) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending != ".png" && ending != ".svg" && ending != ".pdf")
    throw std::runtime_error(
        "the figure's name must end in .png, .svg or .pdf, found '" + path + "'");
  output::TemporaryFile temporary(path);
  const std::string& draft = temporary.path();
  constexpr double points_per_inch = 72.0;
  const double dots =  // per point
      ending == ".png" && page.printed ? page.resolution() / points_per_inch : 1.0;
  const double width = page.unit * page.width * dots;
  const double height = page.unit * page_height * dots;
  const auto pixels = [](double size) { return static_cast<int>(std::ceil(size)); };
  Surface surface(
      ending == ".svg"   ? cairo_svg_surface_create(draft.c_str(), width, height)
      : ending == ".pdf" ? cairo_pdf_surface_create(draft.c_str(), width, height)
                         : cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width),
                                                      pixels(height)),
      cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    cannot_write(path, cairo_status_to_string(cairo_surface_status(surface.get())));
  std::optional<SvgText> text;
  if (ending == ".svg")
    text.emplace(surface.get());
  try {
    const Pen pen(cairo_create(surface.get()), cairo_destroy);
    cairo_scale(pen.get(), dots, dots);
    draw(pen.get());
    cairo_show_page(pen.get());
  } catch (...) {
    text.reset();
    surface.reset();
    throw;
  }
  cairo_status_t status = ending == ".png"
                              ? cairo_surface_write_to_png(surface.get(), draft.c_str())
                              : CAIRO_STATUS_SUCCESS;
  cairo_surface_finish(surface.get());
  if (status == CAIRO_STATUS_SUCCESS)
    status = cairo_surface_status(surface.get());
  if (status != CAIRO_STATUS_SUCCESS)
    cannot_write(path, cairo_status_to_string(status));
  if (text)
    text->insert_into(draft);
  if (dots != 1.0)
    set_png_resolution(draft, page.resolution());
  temporary.take_name_keeping_older();
}

std::string svg_page(const PageSize& page, double height,
                     const std::function<void(cairo_t*)>& draw) {
  std::string svg;
  const Surface surface(cairo_svg_surface_create_for_stream(
                            append, &svg, page.unit * page.width, page.unit * height),
                        cairo_surface_destroy);
  const SvgText text(surface.get());
  draw_on(surface.get(), 1.0, draw);
  cairo_surface_finish(surface.get());
  expect_drawn(surface.get());
  return text.inserted(std::move(svg));
}

std::string png_page(const PageSize& page, double height,
                     const std::function<void(cairo_t*)>& draw) {
  constexpr double pixels_per_point = 2.0;  // for screens of high resolution
  const double scale = page.printed ? pixels_per_point : 1.0;
  const auto pixels = [&](double size) {
    return static_cast<int>(std::ceil(scale * page.unit * size));
  };
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24,
                                                   pixels(page.width), pixels(height)),
                        cairo_surface_destroy);
  draw_on(surface.get(), scale, draw);
  std::string png;
  cairo_surface_write_to_png_stream(surface.get(), append, &png);
  expect_drawn(surface.get());
  return png;
}

}  // namespace blocks::draw
