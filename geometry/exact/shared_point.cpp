#include "geometry/exact/shared_point.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <type_traits>
#include <utility>

namespace blocks::geometry {
namespace exact {
namespace {

static_assert(std::is_same_v<mp_limb_t, unsigned long>);

// The first words hold the numbers of limbs of the four integers, with their signs.
using Sizes = std::array<std::int32_t, 4>;
using Head = std::array<unsigned long, sizeof(Sizes) / sizeof(unsigned long)>;
constexpr std::size_t head = Head().size();

int compare(mpz_srcptr p, mpz_srcptr p_unit, mpz_srcptr q, mpz_srcptr q_unit) {
  if (mpz_cmp(p_unit, q_unit) == 0)
    return mpz_cmp(p, q);
  mpq_t a, b;  // views
  *mpq_numref(a) = *p, *mpq_denref(a) = *p_unit;
  *mpq_numref(b) = *q, *mpq_denref(b) = *q_unit;
  return mpq_cmp(a, b);
}

}  // namespace

Coordinates::Coordinates(const unsigned long* packed) {
  Head words;
  std::copy_n(packed, head, words.begin());
  const auto sizes = std::bit_cast<Sizes>(words);
  const unsigned long* limbs = packed + head;
  std::size_t i = 0;
  for (mpz_ptr number : {x, x_unit, y, y_unit}) {
    mpz_roinit_n(number, limbs, sizes[i]);
    limbs += std::abs(sizes[i++]);
  }
}

std::shared_ptr<const unsigned long[]> packed(const Point& p) {
  const std::array<mpz_srcptr, 4> numbers = {
      mpq_numref(p.x().mpq()), mpq_denref(p.x().mpq()), mpq_numref(p.y().mpq()),
      mpq_denref(p.y().mpq())};
  Sizes sizes{};
  std::size_t count = head;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    count += mpz_size(numbers[i]);
    sizes[i] = mpz_sgn(numbers[i]) * static_cast<int>(mpz_size(numbers[i]));
  }
  const auto result = std::make_shared<unsigned long[]>(count);
  const auto words = std::bit_cast<Head>(sizes);
  unsigned long* limbs = std::copy_n(words.begin(), head, result.get());
  for (mpz_srcptr number : numbers)
    limbs = std::copy_n(mpz_limbs_read(number), mpz_size(number), limbs);
  return result;
}

Point point_of(const ExactPoint& p) {
  if (p.packed() == nullptr)
    return {Rational(p.nearest().x()), Rational(p.nearest().y())};
  const Coordinates from(p.packed());
  Rational x, y;
  mpz_set(mpq_numref(x.mpq()), from.x);
  mpz_set(mpq_denref(x.mpq()), from.x_unit);
  mpz_set(mpq_numref(y.mpq()), from.y);
  mpz_set(mpq_denref(y.mpq()), from.y_unit);
  return {x, y};
}

ExactPoint exact_point(const Point& p) {
  const Vec2 rounded = nearest(p);
  if (p.x() == Rational(rounded.x()) && p.y() == Rational(rounded.y()))
    return {rounded};
  return {rounded, packed(p)};
}

int compare(const ExactPoint& p, const ExactPoint& q) {
  // Rounding keeps the order, so different doubles decide.
  const Vec2 &a = p.nearest(), &b = q.nearest();
  if (a.x() != b.x())
    return a.x() < b.x() ? -1 : 1;
  if (p.packed() == nullptr && q.packed() == nullptr)
    return a.y() == b.y() ? 0 : a.y() < b.y() ? -1 : 1;
  if (p.packed() != nullptr && q.packed() != nullptr) {
    const Coordinates u(p.packed()), v(q.packed());
    const int by_x = compare(u.x, u.x_unit, v.x, v.x_unit);
    return by_x != 0 ? by_x : compare(u.y, u.y_unit, v.y, v.y_unit);
  }
  const Point u = point_of(p), v = point_of(q);
  return static_cast<int>(CGAL::compare_xy(u, v));
}

}  // namespace exact

ExactPoint::ExactPoint(const Vec2& p) : nearest_(p) {}

ExactPoint::ExactPoint(const DecimalPoint& p) : nearest_(p.x.value(), p.y.value()) {
  // Digits behind the point make a double only if the last one is 5.
  const auto may_be_double = [](const Decimal& value) {
    return value.exponent() >= 0 || value.digits().back() == '5';
  };
  const exact::Point point = exact::rational(p);
  if (!may_be_double(p.x) || !may_be_double(p.y) ||
      point.x() != exact::Rational(nearest_.x()) ||
      point.y() != exact::Rational(nearest_.y()))
    packed_ = exact::packed(point);
}

ExactPoint::ExactPoint(const Vec2& nearest,
                       std::shared_ptr<const unsigned long[]> packed)
    : nearest_(nearest), packed_(std::move(packed)) {}

}  // namespace blocks::geometry
