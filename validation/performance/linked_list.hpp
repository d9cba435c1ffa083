// The code of 1982 in C++ and plain doubles. Each block has a linked list of contacts,
// which are checked and evaluated corner by corner (report 3.1-3.3, Appendix D: BOX,
// UPDAT, FORD, MOTION, REBOX). The time loop of the program is compared with it. A step
// of the program by the same rules computes the same results (tests/performance). It
// shares no code with src/dynamics.
#pragma once

#include <algorithm>
#include <vector>

#include "contestant.hpp"
#include "model/model.hpp"

namespace blocks::bench {

class LinkedListCode : public Contestant {
 public:
  /// Returns true for rigid blocks without planes and loads.
  static bool can_step(const Model& model);

  /// Starts from the present state of the model, including the springs of its contacts.
  /// Throws std::invalid_argument unless can_step().
  explicit LinkedListCode(const Model& start);

  std::string name() const override { return "linked lists of 1982"; }
  double work_per_step() const override { return free_; }  ///< block-steps
  void run(long steps) override;

  /// Returns the corners block by block, like Blocks::corner: [L] (2, m).
  Eigen::Matrix2Xd corners() const;
  int acting_contacts() const;
  long searches() const { return searches_; }

 private:
  static constexpr int none = -1;

  struct Corner {
    double x, y;          ///< [L]
    double arm_x, arm_y;  ///< [L] from the centroid
    int box;              ///< box that contains the corner
    int link;             ///< address of the next corner in that box
  };
  struct Block {
    int corners;
    bool fixed;
    int contact;                ///< address of the first contact of its edges
    double x, y, vx, vy, spin;  ///< centroid, velocity, TDOT
    double fx, fy, moment;
    double applied[4];  ///< sums f_i x_j (9)
    double mass, inertia, area;
  };
  /// A contact of Appendix D. `edge` belongs to the block that has the list.
  struct Contact {
    int edge;             ///< NPE
    int corner;           ///< NPC
    int block;            ///< NBC
    int link;             ///< LINK
    bool active;          ///< acted in the last step
    double overlap;       ///< N
    double fn, fs;        ///< FN, FS
    double sine, cosine;  ///< SIN, COS of the edge
    double x, y;          ///< XCP, YCP
  };

  const Corner& corner(int b, int k) const { return corners_[b * max_corners_ + k]; }
  Corner& corner(int b, int k) { return corners_[b * max_corners_ + k]; }
  int after(int b, int k) const { return k + 1 == blocks_[b].corners ? 0 : k + 1; }
  int before(int b, int k) const { return (k == 0 ? blocks_[b].corners : k) - 1; }
  int box_of(double x, double y) const {
    const int i = static_cast<int>((x - settings_.lower.x()) * boxes_per_length_.x()),
              j = static_cast<int>((y - settings_.lower.y()) * boxes_per_length_.y());
    return std::clamp(j, 0, settings_.boxes_y - 1) * settings_.boxes_x +
           std::clamp(i, 0, settings_.boxes_x - 1);
  }

  void step();
  void find_contacts();  ///< UPDAT
  void find_contacts_of_edge(int b, int edge);
  bool listed(int b, int edge, int other, int k) const;
  void contact_forces();  ///< FORD
  bool touches(int b, const Contact& record) const;
  bool faces(double sine, double cosine, int other, int k) const;
  void act(int b, Contact& record);
  void move();  ///< MOTION
  void rebox(int address);

  Settings settings_;
  double dt_, free_ = 0.0;
  Vec2 boxes_per_length_;
  int max_corners_;  ///< NCMAX
  std::vector<Block> blocks_;
  std::vector<Corner> corners_;  ///< NCMAX for each block
  std::vector<int> boxes_;       ///< address of the first corner in each box
  std::vector<Contact> contacts_;
  bool update_ = true;   ///< IUFLG
  double travel_ = 0.0;  ///< UMOST
  long searches_ = 0;    ///< NUPDAT
};

}  // namespace blocks::bench
