// PRIVATE to geometry/: a whole number that keeps its memory when it is set again. In
// long loops this is several times as fast as numbers that allocate each result.
#pragma once

#include <gmp.h>

namespace blocks::geometry::exact {

class Whole {
 public:
  Whole() { mpz_init(value_); }
  ~Whole() { mpz_clear(value_); }
  Whole(const Whole&) = delete;
  Whole& operator=(const Whole&) = delete;
  operator mpz_ptr() { return value_; }           // NOLINT(google-explicit-constructor)
  operator mpz_srcptr() const { return value_; }  // NOLINT(google-explicit-constructor)
  int sign() const { return mpz_sgn(value_); }
  bool is_one() const { return mpz_cmp_ui(value_, 1) == 0; }

 private:
  mpz_t value_;
};

}  // namespace blocks::geometry::exact
