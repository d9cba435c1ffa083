// The fields of the decisions that a checkpoint contains. Part of model_fields.hpp,
// which describes archives.
#pragma once

#include "model/kept_decisions.hpp"
#include "output/checkpoint/checkpoint_field.hpp"

namespace blocks::output {

template <class P, class Archive>
void visit_poses(P& poses, const char* name, Archive& ar) {
  ar.records(name, poses, [](auto& column, auto& pose) {
    auto& [block, centroid, gradient] = pose;
    column({"block", IndexOf::block}, block);
    column("x", centroid.x());
    column("y", centroid.y());
    column("g0", gradient[0]);
    column("g1", gradient[1]);
    column("g2", gradient[2]);
    column("g3", gradient[3]);
  });
}

template <class K, class Archive> void visit_kept(K& kept, Archive& ar) {
  auto& [pairs, contacts, poses, depths, pieces, longest_path, blocks] = kept;
  ar.records("kept/pairs", pairs, [](auto& column, auto& pair) {
    auto& [low, high, validity, contact_count, pose_count, depth_count] = pair;
    auto& [distance, until, pose] = validity;
    column({"low", IndexOf::block}, low);
    column({"high", IndexOf::block}, high);
    column({"motion", not_negative}, distance);
    column({"until", not_negative}, until);
    column("apart_x", pose.apart.x());
    column("apart_y", pose.apart.y());
    column("low_g0", pose.low[0]);
    column("low_g1", pose.low[1]);
    column("low_g2", pose.low[2]);
    column("low_g3", pose.low[3]);
    column("high_g0", pose.high[0]);
    column("high_g1", pose.high[1]);
    column("high_g2", pose.high[2]);
    column("high_g3", pose.high[3]);
    column({"contacts", count_from_0}, contact_count);
    column({"poses", count_from_0}, pose_count);
    column({"depths", count_from_0}, depth_count);
  });
  ar.records("kept/contacts", contacts, [](auto& column, auto& contact) {
    auto& [corner, edge, tested, certain] = contact;
    column({"corner", IndexOf::corner}, corner);
    column({"edge", IndexOf::corner}, edge);
    column("tested", tested);
    column("certain", certain);
  });
  visit_poses(poses, "kept/poses", ar);
  ar.records("kept/depths", depths, [](auto& column, auto& depth) {
    auto& [own_block, own_part, other_block, other_part, side, min, max] = depth;
    column({"own_block", IndexOf::block}, own_block);
    column("own_part", own_part);
    column({"other_block", IndexOf::block}, other_block);
    column("other_part", other_part);
    column("side", side);
    column("least", min);
    column("most", max);
  });
  ar({"kept/pieces", IndexOf::block}, pieces);
  ar({"kept/most", not_negative}, longest_path);
  ar({"kept/blocks", not_negative}, blocks);
}

}  // namespace blocks::output
