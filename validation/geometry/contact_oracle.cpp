#include "validation/geometry/contact_oracle.hpp"

#include <mpfr.h>

#include <utility>

#include "geometry/contact_predicates.hpp"

namespace blocks::validation {
namespace {

/// The precision of a thread. Its end also frees what MPFR caches for the thread.
struct ThreadBits {
  mpfr_prec_t bits = 0;
  ~ThreadBits() { mpfr_free_cache2(MPFR_FREE_LOCAL_CACHE); }
};
thread_local ThreadBits of_thread;

class Number {
 public:
  Number() { mpfr_init2(value_, of_thread.bits); }
  explicit Number(double x) : Number() { mpfr_set_d(value_, x, MPFR_RNDN); }
  Number(const Number& other) : Number() { mpfr_set(value_, other.value_, MPFR_RNDN); }
  Number& operator=(const Number&) = delete;
  ~Number() { mpfr_clear(value_); }

  friend Number operator+(const Number& a, const Number& b) {
    Number sum;
    mpfr_add(sum.value_, a.value_, b.value_, MPFR_RNDN);
    return sum;
  }
  friend Number operator-(const Number& a, const Number& b) {
    Number difference;
    mpfr_sub(difference.value_, a.value_, b.value_, MPFR_RNDN);
    return difference;
  }
  friend Number operator*(const Number& a, const Number& b) {
    Number product;
    mpfr_mul(product.value_, a.value_, b.value_, MPFR_RNDN);
    return product;
  }
  int sign() const { return mpfr_sgn(value_); }
  Number size() const {
    Number positive;
    mpfr_abs(positive.value_, value_, MPFR_RNDN);
    return positive;
  }
  static Number sin10() {
    Number angle;
    mpfr_const_pi(angle.value_, MPFR_RNDN);
    mpfr_div_ui(angle.value_, angle.value_, 18, MPFR_RNDN);
    mpfr_sin(angle.value_, angle.value_, MPFR_RNDN);
    return angle;
  }
  static Number power_of_two(long exponent) {
    Number power;
    mpfr_set_ui_2exp(power.value_, 1, exponent, MPFR_RNDN);
    return power;
  }

 private:
  mpfr_t value_;
};

struct Vector {
  Number x, y;

  Vector(const Vec2& from, const Vec2& to)
      : x(Number(to.x()) - Number(from.x())), y(Number(to.y()) - Number(from.y())) {}
};

Number cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }

/// Is sine >= -sin(10 degrees) sqrt(q)? Decided by the sign of sine |sine| + sin^2 q.
bool faces(const Number& sine, const Number& q) {
  if (q.sign() == 0 || sine.sign() >= 0)
    return true;
  const Number sin10 = Number::sin10();
  const Number excess = sin10 * sin10 * q - sine * sine;
  // The terms are below 2 q and have relative errors of a few 2^-bits.
  const Number error = Number::power_of_two(8 - static_cast<long>(of_thread.bits)) * q;
  if ((excess.size() - error).sign() > 0)
    return excess.sign() > 0;
  of_thread.bits *= 2;
  return faces(sine, q);  // The arguments keep their own bits, so they remain exact.
}

/// Computes all answers. Returns false if MPFR rounded, so they may not be exact.
bool try_to_judge(const ContactCase& k, ContactTruth& truth) {
  mpfr_clear_flags();
  const Vector e(k.p1, k.p2), f(k.q1, k.q2), w(k.p1, k.c);
  const Number area = cross(w, e), other = cross(Vector(k.q1, k.c), f);
  const Number length2 = dot(e, e), other_length2 = dot(f, f);
  const Number slack = Number(geometry::contact_slack) * length2;
  const Number along = dot(w, e);
  truth.overlap_sign = area.sign();
  truth.near_or_inside = (area + slack).sign() >= 0;
  truth.between = (along + slack).sign() >= 0 && (length2 + slack - along).sign() >= 0;
  truth.turn_sign = cross(Vector(k.centroid, k.c), e).sign();
  truth.compare_depths =
      (area * area.size() * other_length2 - other * other.size() * length2).sign();
  const Vector t(k.c, k.neighbour);
  const Number sine = cross(e, t), q = length2 * dot(t, t);
  if (mpfr_inexflag_p())
    return false;
  truth.faces_edge = faces(sine, q);
  return true;
}

}  // namespace

ContactTruth judge(const ContactCase& k) {
  ContactTruth truth;
  for (mpfr_prec_t enough = 512;; enough *= 2) {
    of_thread.bits = enough;
    if (try_to_judge(k, truth))
      return truth;
  }
}

}  // namespace blocks::validation
