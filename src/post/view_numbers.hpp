// The numbers of the page of `blocks view`: six decimal digits each, told as what they
// differ from a guess that the page can make as well. Knows columns of numbers, nothing
// of blocks.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace blocks::post {

/// digits * 10^power with 100,000 <= |digits| < 1,000,000; no digits: zero.
struct SixDigits {
  int digits = 0, power = 0;
};

/// A power that no number has: infinite with digits 1 or -1, otherwise no number.
constexpr int not_finite = 127;

/// The six leading digits, rounded; zero below 1e-37.
SixDigits six_digits_of(double value);

/// The float nearest to it: "%.6g" of this and of the value is the same for
/// 1e-37 < |value| < 3e38. The page computes the same bits.
float float_of(const SixDigits& number);

/// A column of frames x rows numbers, frame by frame.
struct DigitColumn {
  std::size_t rows = 0;
  std::vector<SixDigits> exact;  ///< a zero has the power of the frame before
  std::vector<float> shown;      ///< float_of each
  void add(double value);
};

/// What the page takes a number for before it is told; i counts through the column.
using Guess = std::function<double(std::size_t i)>;

/// The number of the frame before, or that and what it changed by then, whichever
/// leaves less to be told.
struct TimeGuess {
  bool linear = false;
  /// The column must outlive it.
  Guess of(const DigitColumn& column) const;
};
TimeGuess better_guess(const DigitColumn& column);

/// digits - guess / 10^power, folded (0, -1, 1, -2 ...); a guess of no number or of too
/// many digits counts as the nearest that a number may have.
std::vector<std::uint32_t> differences(const DigitColumn& column, const Guess& guess);

/// 0, -1, 1, -2, 2 ... as 0, 1, 2, 3, 4 ...
std::uint32_t folded(std::int64_t value);

}  // namespace blocks::post
