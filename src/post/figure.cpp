#include "post/figure.hpp"

#include "post/figure_page.hpp"
#include "post/page_file.hpp"

namespace blocks::post {

void draw_figure(const std::string& path, const ResultsReader& results,
                 const std::vector<long>& frames, const FigureOptions& options) {
  const FigureScales scales = survey_scales(results, frames, options);
  const Frame first = results.frame(0);
  const FigurePage page(frames.size(), results.title(), scales, options);
  write_page(path, options.page, page.height(), [&](cairo_t* cairo) {
    Pen pen(cairo, options.page);
    page.begin(pen);
    for (std::size_t k = 0; k < frames.size(); ++k) {
      const Frame now = results.frame(frames[k]);
      const FrameContacts contacts = contacts_for(options, results, frames[k]);
      page.picture(pen, k, {now, first, contacts});
      if (k + 1 == frames.size())
        page.end(pen, {now, first, contacts});
    }
  });
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
