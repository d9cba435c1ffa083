#include "geometry/exact/line.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <utility>

namespace blocks::geometry::exact {
namespace {

// Numbers of this thread for intermediate results.
struct Scratch {
  Place p, q;
  Whole a, b, c, common;
};
Scratch& scratch() {
  static thread_local Scratch numbers;
  return numbers;
}

// Scales two integers by one power of two, so that the larger one is between 1/2 and 1.
void scaled(mpz_srcptr a, mpz_srcptr b, double& x, double& y) {
  long i = 0, j = 0;
  x = mpz_get_d_2exp(&i, a);
  y = mpz_get_d_2exp(&j, b);
  const long top = x == 0.0 ? j : y == 0.0 ? i : std::max(i, j);
  x = std::ldexp(x, static_cast<int>(std::max(i - top, -2000L)));
  y = std::ldexp(y, static_cast<int>(std::max(j - top, -2000L)));
}

// A double as mantissa * 2^exponent, with an odd mantissa or 0.
struct Binary {
  explicit Binary(double value) {
    constexpr int digits = std::numeric_limits<double>::digits;
    mantissa = static_cast<long>(std::ldexp(std::frexp(value, &exponent), digits));
    const int zeros =
        mantissa == 0 ? 0 : std::countr_zero(static_cast<unsigned long>(mantissa));
    mantissa >>= zeros;
    exponent = mantissa == 0 ? 0 : exponent - digits + zeros;
  }
  long mantissa;
  int exponent = 0;
};

// Sets to = p q - r s.
void set_difference(mpz_ptr to, mpz_srcptr p, mpz_srcptr q, mpz_srcptr r,
                    mpz_srcptr s) {
  mpz_mul(to, p, q);
  mpz_submul(to, r, s);
}

int compare_products(mpz_srcptr p, mpz_srcptr q, mpz_srcptr r, mpz_srcptr s) {
  Scratch& numbers = scratch();
  mpz_mul(numbers.a, p, q);
  mpz_mul(numbers.b, r, s);
  return mpz_cmp(numbers.a, numbers.b);
}

}  // namespace

void Lines::add(const ExactPoint& p, const ExactPoint& q) {
  Scratch& numbers = scratch();
  Place &u = numbers.p, &v = numbers.q;
  u.set(p);
  v.set(q);
  set_difference(numbers.a, u.y, v.w, v.y, u.w);
  set_difference(numbers.b, v.x, u.w, u.x, v.w);
  set_difference(numbers.c, u.x, v.y, v.x, u.y);
  mpz_gcd(numbers.common, numbers.a, numbers.b);
  if (!numbers.common.is_one())
    mpz_gcd(numbers.common, numbers.common, numbers.c);
  if (!numbers.common.is_one())
    for (Whole* value : {&numbers.a, &numbers.b, &numbers.c})
      mpz_divexact(*value, *value, numbers.common);
  Entry entry{limbs_.size(), {}, 0.0, 0.0};
  scaled(numbers.b, numbers.a, entry.run, entry.rise);
  entry.rise = 0.0 - entry.rise;
  std::size_t i = 0;
  for (const Whole* value : {&numbers.a, &numbers.b, &numbers.c}) {
    const mp_limb_t* limbs = mpz_limbs_read(*value);
    limbs_.insert(limbs_.end(), limbs, limbs + mpz_size(*value));
    entry.sizes[i++] = value->sign() * static_cast<std::int32_t>(mpz_size(*value));
  }
  entries_.push_back(entry);
}

Line Lines::operator[](std::size_t i) const {
  const Entry& entry = entries_[i];
  Line line;
  const mp_limb_t* limbs = limbs_.data() + entry.begin;
  std::size_t k = 0;
  for (mpz_ptr number : {line.a, line.b, line.c}) {
    mpz_roinit_n(number, limbs, entry.sizes[k]);
    limbs += std::abs(entry.sizes[k++]);
  }
  return line;
}

bool Lines::are_equal(std::size_t i, std::size_t j) const {
  const Entry &p = entries_[i], &q = entries_[j];
  const auto at = [this](std::size_t k) {
    return limbs_.begin() + static_cast<std::ptrdiff_t>(k);
  };
  return std::equal(std::begin(p.sizes), std::end(p.sizes), q.sizes) &&
         std::equal(at(p.begin), at(end_of(i)), at(q.begin));
}

std::uint64_t Lines::hash(std::size_t i) const {
  std::uint64_t sum = 0;
  const auto add = [&sum](std::uint64_t value) {  // Fibonacci hashing
    sum = (sum ^ (sum >> 29) ^ value) * 0x9E3779B97F4A7C15ULL;
  };
  for (const std::int32_t size : entries_[i].sizes)
    add(static_cast<std::uint64_t>(size));
  for (std::size_t k = entries_[i].begin; k < end_of(i); ++k)
    add(limbs_[k]);
  return sum;
}

int Lines::turn(std::size_t i, std::size_t j) const {
  const Entry &s = entries_[i], &t = entries_[j];
  // The components are at most 1 and have an error of 2^-52 or less, so the two
  // products are certain to 2^-49.
  const double area = s.run * t.rise - s.rise * t.run;
  if (std::abs(area) > 0x1p-49)
    return area > 0.0 ? 1 : -1;
  const Line u = (*this)[i], v = (*this)[j];
  const int order = compare_products(u.a, v.b, u.b, v.a);
  return order > 0 ? 1 : order < 0 ? -1 : 0;
}

void Place::set(const ExactPoint& p) {
  if (p.packed() != nullptr) {
    const Coordinates from(p.packed());
    if (mpz_cmp(from.x_unit, from.y_unit) == 0) {
      mpz_set(x, from.x);
      mpz_set(y, from.y);
      mpz_set(w, from.x_unit);
      return;
    }
    mpz_lcm(w, from.x_unit, from.y_unit);
    mpz_divexact(rest_, w, from.x_unit);
    mpz_mul(x, from.x, rest_);
    mpz_divexact(rest_, w, from.y_unit);
    mpz_mul(y, from.y, rest_);
    return;
  }
  const Binary u(p.nearest().x()), v(p.nearest().y());
  const int shift = std::max({-u.exponent, -v.exponent, 0});
  mpz_set_si(x, u.mantissa);
  mpz_mul_2exp(x, x, static_cast<mp_bitcnt_t>(u.exponent + shift));
  mpz_set_si(y, v.mantissa);
  mpz_mul_2exp(y, y, static_cast<mp_bitcnt_t>(v.exponent + shift));
  mpz_set_ui(w, 1);
  mpz_mul_2exp(w, w, static_cast<mp_bitcnt_t>(shift));
}

void Place::set(const Line& s, const Line& t) {
  set_difference(x, s.b, t.c, s.c, t.b);
  set_difference(y, s.c, t.a, s.a, t.c);
  set_difference(w, s.a, t.b, s.b, t.a);
  if (w.sign() < 0)
    for (Whole* value : {&x, &y, &w})
      mpz_neg(*value, *value);
}

Vec2 Place::nearest() const {
  return {rounded_quotient(x, w, 0), rounded_quotient(y, w, 0)};
}

Point Place::reduced() const {
  Rational px, py;
  for (const auto& [to, from] : {std::pair(&px, &x), std::pair(&py, &y)}) {
    mpz_set(mpq_numref(to->mpq()), *from);
    mpz_set(mpq_denref(to->mpq()), w);
    mpq_canonicalize(to->mpq());
  }
  return {px, py};
}

int compare(const Place& p, const Place& q) {
  const int by_x = compare_products(p.x, q.w, q.x, p.w);
  return by_x != 0 ? by_x : compare_products(p.y, q.w, q.y, p.w);
}

int side_of(const Line& line, const Place& p) {
  Whole& sum = scratch().a;
  mpz_mul(sum, line.a, p.x);
  mpz_addmul(sum, line.b, p.y);
  mpz_addmul(sum, line.c, p.w);
  return sum.sign();
}

}  // namespace blocks::geometry::exact
