// Puts the forces of a stress field on contacts (INSITU,
// docs/rest.md#stress-in-the-ground).
#pragma once

#include <vector>

#include "dynamics/contacts/law_table.hpp"
#include "dynamics/energy/spring_energy.hpp"
#include "dynamics/preparation/contact_table.hpp"
#include "dynamics/preparation/face_loads.hpp"
#include "dynamics/preparation/in_situ.hpp"

namespace blocks::dynamics {

/// Loads contacts one by one. Refers to the model, the laws and the report.
class ContactLoading {
 public:
  ContactLoading(Model& model, const LawTable& laws, InSituReport& report)
      : model_(model), laws_(laws), report_(report), table_(model) {}

  /// Loads the contacts of two blocks: the springs are the forces, and offsets keep
  /// them acting. loads: all loads of the two blocks. They also tell which contacts
  /// share the end of a face.
  void load(const std::vector<FaceLoad>& loads);
  /// Puts the contacts into the list of the model.
  void finish() { table_.finish(); }

 private:
  bool is_bonded(const FaceLoad& load);
  bool carries(const FaceLoad& load);
  void put(const FaceLoad& load, const std::vector<FaceLoad>& loads);
  void set(ContactEntry& entry, const FaceLoad& load, int law, double length);
  void test(const ContactEntry& entry, int law);

  Model& model_;
  const LawTable& laws_;
  InSituReport& report_;
  ContactTable table_;
};

}  // namespace blocks::dynamics
