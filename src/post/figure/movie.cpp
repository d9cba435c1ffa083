#include "post/figure/movie.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "files/file_tools.hpp"
#include "post/figure/figure_page.hpp"

namespace blocks::post {

using namespace draw;

namespace {

/// Runs ffmpeg and writes pictures to it through a pipe.
class Encoder {
 public:
  explicit Encoder(std::vector<std::string> arguments) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0)
      throw files::FileError("cannot start ffmpeg: cannot create a pipe");
    before_ = std::signal(SIGPIPE, SIG_IGN);  // write() reports it if ffmpeg has exited
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t usual;
    sigemptyset(&usual);
    sigaddset(&usual, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &usual);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    std::vector<char*> words;
    words.reserve(arguments.size() + 1);
    for (std::string& word : arguments)
      words.push_back(word.data());
    words.push_back(nullptr);
    const int fault =
        posix_spawnp(&child_, words[0], &actions, &attributes, words.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&attributes);
    close(ends[0]);
    to_child_ = ends[1];
    if (fault != 0) {
      child_ = -1;
      finish();
      throw files::FileError(
          "a movie needs the program ffmpeg, which is not installed here\n  hint: apt "
          "install ffmpeg, or draw a picture with -o NAME.png");
    }
  }
  ~Encoder() { finish(); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  /// Writes bytes to ffmpeg; false if it no longer reads.
  bool put(const unsigned char* bytes, std::size_t size) {
    while (size > 0) {
      const ssize_t sent = write(to_child_, bytes, size);
      if (sent < 0 && errno == EINTR)
        continue;
      if (sent <= 0)
        return false;
      bytes += sent;
      size -= static_cast<std::size_t>(sent);
    }
    return true;
  }

  /// Waits until ffmpeg exits; true if it succeeded.
  bool finish() {
    if (to_child_ >= 0) {
      close(to_child_);
      std::signal(SIGPIPE, before_);
    }
    to_child_ = -1;
    int status = -1;
    if (child_ > 0)
      while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
      }
    child_ = -1;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }

 private:
  pid_t child_ = -1;
  int to_child_ = -1;
  void (*before_)(int) = SIG_DFL;
};

/// Returns the command line of ffmpeg. The bytes of a pixel are blue, green, red and
/// unused, as cairo stores them on a little-endian machine. Width and height are even,
/// as the usual MP4 codec requires.
std::vector<std::string> ffmpeg(const std::string& draft, bool gif, int width,
                                int height, double rate) {
  std::vector<std::string> words = {"ffmpeg",
                                    "-hide_banner",
                                    "-loglevel",
                                    "error",
                                    "-y",
                                    "-f",
                                    "rawvideo",
                                    "-pixel_format",
                                    "bgr0",
                                    "-video_size",
                                    fmt::format("{}x{}", width, height),
                                    "-framerate",
                                    fmt::format("{}", rate),
                                    "-i",
                                    "pipe:0",
                                    "-an"};
  const std::vector<std::string> as_gif = {
      "-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=none",
      "-f", "gif"};
  const std::vector<std::string> as_mp4 = {
      "-c:v",    "libx264",   "-crf",       "18", "-pix_fmt",
      "yuv420p", "-movflags", "+faststart", "-f", "mp4"};
  const auto& more = gif ? as_gif : as_mp4;
  words.insert(words.end(), more.begin(), more.end());
  words.push_back("file:" + draft);
  return words;
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Context = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

}  // namespace

bool is_movie(const std::string& path) {
  const std::string ending = std::filesystem::path(path).extension().string();
  return ending == ".mp4" || ending == ".gif";
}

void draw_movie(const std::string& path, const ResultsReader& results,
                const std::vector<long>& frames, double rate,
                const FigureOptions& options) {
  if (!(rate >= 0.1 && rate <= 100))
    throw std::runtime_error("a movie can have 0.1 to 100 pictures per second");
  const FigureScales scales = survey_scales(results, frames, options);
  const FigurePage page(1, results.title(), scales, options);
  const auto even = [](double size) {
    return 2 * static_cast<int>(std::lround(size / 2));
  };
  const int width = even(options.page.unit * options.page.width),
            height = even(options.page.unit * page.height());
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height),
                        cairo_surface_destroy);
  files::TemporaryFile temporary(path);  // also removes an incomplete movie
  Encoder encoder(ffmpeg(temporary.path(),
                         std::filesystem::path(path).extension() == ".gif", width,
                         height, rate));
  const auto expect = [&](bool well) {
    if (!well)
      throw files::FileError("cannot write " + path + ": ffmpeg failed");
  };
  for_each_picture(results, frames, options, [&](std::size_t, const Picture& picture) {
    {
      const Context cairo(cairo_create(surface.get()), cairo_destroy);
      Pen pen(cairo.get(), options.page);
      page.begin(pen);
      page.picture(pen, 0, picture);
      page.end(pen, picture);
    }
    cairo_surface_flush(surface.get());
    const auto stride =
        static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
    expect(encoder.put(cairo_image_surface_get_data(surface.get()),
                       stride * static_cast<std::size_t>(height)));
  });
  expect(encoder.finish());
  temporary.take_name_keeping_older();
}

}  // namespace blocks::post
