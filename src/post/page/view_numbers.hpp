// Encodes the numbers of the page of `blocks view`. Each has six decimal digits, stored
// as the difference from a prediction that the page computes too. Independent of the
// model.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace blocks::post {

/// digits * 10^power with 100,000 <= |digits| < 1,000,000; digits = 0 means zero.
struct SixDigits {
  int digits = 0, power = 0;
};

/// A power that no finite number has. It means infinity if digits is 1 or -1, otherwise
/// NaN.
constexpr int not_finite = 127;

/// Returns the six leading digits, rounded; zero below 1e-37.
SixDigits six_digits_of(double value);

/// Returns the nearest float. For 1e-37 < |value| < 3e38, "%.6g" prints it like the
/// original value. The page computes the same bits.
float float_of(const SixDigits& number);

/// Returns the four leading digits, which are more than colours show and need less
/// space.
float four_digits(double value);

/// A column of frames x rows numbers, frame by frame.
struct DigitColumn {
  std::size_t rows = 0;
  std::vector<SixDigits> exact;  ///< a zero has the power of the previous frame
  std::vector<float> shown;      ///< float_of each
  void add(double value);
};

/// Returns the predicted value of number i of the column.
using Guess = std::function<double(std::size_t i)>;

/// Predicts from the previous frame, or linearly from the previous two, whichever
/// leaves smaller differences.
struct TimeGuess {
  bool linear = false;
  /// The column must outlive it.
  Guess of(const DigitColumn& column) const;
};
TimeGuess better_guess(const DigitColumn& column);

/// Returns digits - guess / 10^power for each number, folded (0, -1, 1, -2 ...). A
/// guess that is NaN counts as 0; one with too many digits is clamped to six digits.
std::vector<std::uint32_t> differences(const DigitColumn& column, const Guess& guess);

/// Maps 0, -1, 1, -2, 2 ... to 0, 1, 2, 3, 4 ...
std::uint32_t folded(std::int64_t value);

}  // namespace blocks::post
