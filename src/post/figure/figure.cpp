#include "post/figure/figure.hpp"

#include "draw/page_file.hpp"
#include "post/figure/figure_page.hpp"

namespace blocks::post {

using namespace draw;

namespace {

/// Draws a sheet of frames; call it once.
class Sheet {
 public:
  Sheet(const ResultsReader& results, const std::vector<long>& frames,
        const FigureOptions& options)
      : results_(results), frames_(frames), options_(options),
        scales_(survey_scales(results, frames, options)),
        page_(frames.size(), results.title(), scales_, options) {}

  double height() const { return page_.height(); }

  void draw(cairo_t* cairo) const {
    Pen pen(cairo, options_.page);
    page_.begin(pen);
    for_each_picture(results_, frames_, options_,
                     [&](std::size_t k, const Picture& one) {
                       page_.picture(pen, k, one);
                       if (k + 1 == frames_.size())
                         page_.end(pen, one);
                     });
  }

 private:
  const ResultsReader& results_;
  const std::vector<long>& frames_;
  const FigureOptions& options_;
  const FigureScales scales_;
  const FigurePage page_;
};

}  // namespace

void draw_figure(const std::string& path, const ResultsReader& results,
                 const std::vector<long>& frames, const FigureOptions& options) {
  const Sheet sheet(results, frames, options);
  write_page(path, options.page, sheet.height(),
             [&](cairo_t* cairo) { sheet.draw(cairo); });
}

std::string figure_svg(const ResultsReader& results, const std::vector<long>& frames,
                       const FigureOptions& options) {
  const Sheet sheet(results, frames, options);
  return svg_page(options.page, sheet.height(),
                  [&](cairo_t* cairo) { sheet.draw(cairo); });
}

std::string figure_png(const ResultsReader& results, const std::vector<long>& frames,
                       const FigureOptions& options) {
  const Sheet sheet(results, frames, options);
  return png_page(options.page, sheet.height(),
                  [&](cairo_t* cairo) { sheet.draw(cairo); });
}

void draw_frame(const std::string& path, const Frame& now, const Frame& first,
                const std::string& title, const FigureOptions& options) {
  const FrameContacts none;
  const Picture picture{now, first, none};
  ScaleSurvey survey(options);
  survey.include(picture);
  const FigureScales scales = survey.scales();
  const FigurePage page(1, title, scales, options);
  write_page(path, options.page, page.height(), [&](cairo_t* cairo) {
    Pen pen(cairo, options.page);
    page.begin(pen);
    page.picture(pen, 0, picture);
    page.end(pen, picture);
  });
}

}  // namespace blocks::post
