// Every card with all its fields and with its defaults (report Appendix A).
#include <gtest/gtest.h>

#include "deck_test_tools.hpp"

namespace blocks::deck {
namespace {

/// Parses a deck with this card and returns it.
template <class T> T card(const std::string& text) {
  const Parsed parsed = parse_text(preliminary_cards + text);
  EXPECT_EQ(parsed.messages, "") << text;
  return parsed.only<T>();
}

std::vector<double> doubles(const std::vector<Exact>& list) {
  std::vector<double> out;
  for (const Exact& one : list) {
    out.push_back(one.value.value());
  }
  return out;
}

using V = std::vector<double>;

TEST(Cards, PreliminaryCardsHaveAllTheirFields) {
  const Parsed p = parse_text(
      "start, 10, 4\nA title, 1982\nxlimits, -1, 2\nylimits, -3.D0, 4\n"
      "boxes, 5, 6, .25\nstiff, 1.D7, 5e6\nfraction, 1\nmaterial, 2, 9, 8, 7\n"
      "function, 2\n0, 1\n2, 3\nrigid\nseed, 42\nend\n");
  EXPECT_EQ(p.messages, "");
  EXPECT_EQ(p.only<Start>().nblok.value, 10);
  EXPECT_EQ(p.only<Start>().ncmx.value, 4);
  EXPECT_EQ(p.only<Start>().title, "A title, 1982");
  EXPECT_EQ(p.only<XLimits>().xmin.value, -1.0);
  EXPECT_EQ(p.only<XLimits>().xmax.value, 2.0);
  EXPECT_EQ(p.only<YLimits>().ymin.value, -3.0);
  EXPECT_EQ(p.only<YLimits>().ymax.value, 4.0);
  EXPECT_EQ(p.only<Boxes>().iboxes.value, 5);
  EXPECT_EQ(p.only<Boxes>().jboxes.value, 6);
  EXPECT_EQ(p.only<Boxes>().ctol.value, 0.25);
  EXPECT_EQ(p.only<Stiff>().stifn.value, 1e7);
  EXPECT_EQ(p.only<Stiff>().stifs.value, 5e6);
  EXPECT_EQ(p.only<Fraction>().tfrac.value, 1.0);
  EXPECT_EQ(p.only<Material>().mat.value, 2);
  EXPECT_EQ(p.only<Material>().e.value, 9.0);
  EXPECT_EQ(p.only<Material>().g.value, 8.0);
  EXPECT_EQ(p.only<Material>().rho.value, 7.0);
  ASSERT_EQ(p.only<Function>().t.size(), 2U);
  EXPECT_EQ(p.only<Function>().t[1].value, 2.0);
  EXPECT_EQ(p.only<Function>().p[1].value, 3.0);
  EXPECT_EQ(p.only<Seed>().seed.value, 42);
  EXPECT_NO_THROW(p.only<Rigid>());
  EXPECT_NO_THROW(p.only<End>());
  EXPECT_EQ(p.deck.commands.size(), 11U);
}

TEST(Cards, PreliminaryCardsHaveDefaults) {
  const Parsed p = parse_text("START 10 4\nT\nXLIMITS 0 1\nYLIMITS 0 1\nBOXES 1 1\n"
                              "STIFF, , 2.\nFRACTION .1\nMATERIAL 1,,,5.\nEND");
  EXPECT_EQ(p.messages, "");
  EXPECT_EQ(p.only<Boxes>().ctol.value, 0.1);
  EXPECT_FALSE(p.only<Boxes>().ctol.given);
  EXPECT_EQ(p.only<Boxes>().ctol.where.line, 5);
  EXPECT_EQ(p.only<Stiff>().stifn.value, 1e6);
  EXPECT_FALSE(p.only<Stiff>().stifn.given);
  EXPECT_TRUE(p.only<Stiff>().stifs.given);
  EXPECT_EQ(p.only<Stiff>().stifs.where.column, 10);
  EXPECT_EQ(p.only<Material>().e.value, 0.0);
  EXPECT_FALSE(p.only<Material>().g.given);
}

TEST(Cards, CreateHasTheCornersOfABlock) {
  const auto c = card<Create>("CREATE, 3., 2, -1\n0, 1, .1\n0, 1, 0\n");
  EXPECT_EQ(c.nc.value, 3);
  EXPECT_EQ(c.mat.value, 2);
  EXPECT_EQ(c.ifix.value, -1);
  EXPECT_EQ(doubles(c.x), (V{0, 1, .1}));
  EXPECT_EQ(doubles(c.y), (V{0, 1, 0}));
  EXPECT_EQ(c.x[2].where.line, 10);
  EXPECT_EQ(c.x[2].where.column, 7);
  EXPECT_FALSE(c.loop.has_value());
  EXPECT_EQ(card<Create>("CREATE, 3, 2\n0, 1, 1\n0, 1, 0\n").ifix.value, 0);
}

TEST(Cards, CloopActsOnTheNextCreateOnly) {
  const Parsed p =
      parse_text(preliminary_cards + "CLOOP, 4, , 1.5\nCREATE, 3, 1\n0,1,1\n0,1,0\n"
                                     "CREATE, 3, 1\n0,1,1\n0,1,0\n");
  EXPECT_EQ(p.messages, "");
  const auto& first = std::get<Create>(p.deck.commands[7].card);
  ASSERT_TRUE(first.loop.has_value());
  EXPECT_EQ(first.loop->nloop.value, 4);
  EXPECT_EQ(first.loop->radd.value.value(), 0.0);
  EXPECT_EQ(first.loop->zadd.value.value(), 1.5);
  EXPECT_FALSE(std::get<Create>(p.deck.commands[8].card).loop.has_value());
}

TEST(Cards, LayerHasFourCorners) {
  const auto even = card<Layer>("LAYER, -5, 3, 1, 2, 3, 4, 5, 6, 7, 8\n");
  EXPECT_EQ(even.ns.value, -5);
  EXPECT_EQ(even.mat.value, 3);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(even.corners[i].value.value(), static_cast<double>(i + 1));
  }
  EXPECT_EQ(even.rcommand.value, "");
  EXPECT_TRUE(even.bottom.empty());
  const auto random = card<Layer>("LAYER, -5, 3, 1, 2, 3, 4, 5, 6,\n7, 8, random\n");
  EXPECT_EQ(random.rcommand.value, "RANDOM");
  EXPECT_TRUE(random.rcommand.given);
  EXPECT_EQ(random.corners[7].where.line, 10);
}

// By A.2.4 a short list is completed as sb1, sb2, sb2, ...
TEST(Cards, LayerCompletesShortLists) {
  const std::string head = "LAYER, 4, 1, 0, 0, 0, 1, 8, 1, 8, 0\n";
  auto l = card<Layer>(head + "1, 2\n3\n");
  EXPECT_EQ(doubles(l.bottom), (V{1, 2, 2, 2}));
  EXPECT_EQ(doubles(l.top), (V{3, 3, 3, 3}));
  EXPECT_TRUE(l.bottom[1].given);
  EXPECT_FALSE(l.bottom[2].given);
  l = card<Layer>(head + "1, 2, 3\n4\n5\n6, 7, 8\n");
  EXPECT_EQ(doubles(l.bottom), (V{1, 2, 3, 4}));
  EXPECT_EQ(doubles(l.top), (V{5, 6, 7, 8}));
}

// Three lines of values can be split into two lists in two ways.
TEST(Cards, CommaAtTheEndOfALineContinuesAList) {
  const std::string head = "LAYER, 4, 1, 0, 0, 0, 1, 8, 1, 8, 0\n";
  EXPECT_EQ(doubles(card<Layer>(head + "1, 2\n3, 4,\n5, 6\n").bottom), (V{1, 2, 2, 2}));
  EXPECT_EQ(doubles(card<Layer>(head + "1, 2,\n3, 4\n5, 6\n").bottom), (V{1, 2, 3, 4}));
}

TEST(Cards, GeometryHasAllItsDecimals) {
  // This is above the double nearest to 0.1 by less than doubles can show.
  const auto m = card<Merge>("MERGE, 0.1000000000000000056\n");
  EXPECT_NE(m.aratio.value.digits().find("1000000000000000056"), std::string::npos);
  EXPECT_EQ(m.aratio.value.value(), 0.1);
}

TEST(Cards, OrientHasTwoAngles) {
  const auto o = card<Orient>("ORIENT, -5, 10\n");
  EXPECT_EQ(o.angmin.value.value(), -5.0);
  EXPECT_EQ(o.angplus.value.value(), 10.0);
  EXPECT_EQ(card<Orient>("ORIENT\n").angplus.value.value(), 0.0);
}

TEST(Cards, SplaneHasTwoPoints) {
  const auto s = card<Splane>("SPLANE, 1, 2, 3, 4\n");
  EXPECT_EQ((V{s.x1.value, s.y1.value, s.x2.value, s.y2.value}), (V{1, 2, 3, 4}));
}

TEST(Cards, GravityHasTwoComponents) {
  const auto g = card<Gravity>("GRAVITY, , -9.8\n");
  EXPECT_EQ((V{g.gravx.value, g.gravy.value}), (V{0, -9.8}));
}

TEST(Cards, FixNamesABlock) { EXPECT_EQ(card<Fix>("FIX, 3\n").nblok.number.value, 3); }

TEST(Cards, PressureHasAnArrivalTime) {
  const auto p = card<PressBc>("PRESSBC, 1, 2, 3, 4, 5\n");
  EXPECT_EQ(p.nblok.number.value, 1);
  EXPECT_EQ(p.nside.number.value, 2);
  EXPECT_EQ((V{p.p1.value, p.p2.value, p.tarriv.value}), (V{3, 4, 5}));
  EXPECT_EQ(card<PressBc>("PRESSBC, 1, 2, 3, 4\n").tarriv.value, 0.0);
}

TEST(Cards, ForceHasAnArrivalTime) {
  const auto f = card<Force>("FORCE, 1, 2, 3, 4\n");
  EXPECT_EQ((V{f.fx.value, f.fy.value, f.tarriv.value}), (V{2, 3, 4}));
  EXPECT_EQ(card<Force>("FORCE, 1, 2\n").fy.value, 0.0);
}

TEST(Cards, FrictionAndDampingAreZeroByDefault) {
  EXPECT_EQ(card<Frictn>("FRICTN, .6\n").fric.value, .6);
  EXPECT_EQ(card<Frictn>("FRICTN\n").fric.value, 0.0);
  EXPECT_EQ(card<Damping>("DAMPING, .2\n").beta.value, .2);
  EXPECT_EQ(card<Damping>("DAMPING\n").beta.value, 0.0);
}

TEST(Cards, SetVelNamesARangeOfBlocks) {
  const auto v = card<SetVel>("SETVEL, 2, -1, 3, 4, 5\n");
  EXPECT_EQ(v.nb1.number.value, 2);
  EXPECT_EQ(v.nb2.value, -1);
  EXPECT_EQ((V{v.vx.value, v.vy.value, v.tdot.value}), (V{3, 4, 5}));
  EXPECT_EQ(card<SetVel>("SETVEL, 2\n").nb2.value, 0);
}

TEST(Cards, SetVelMNamesAMaterial) {
  const auto m = card<SetVelM>("SETVELM, 7, 3, 4, 5\n");
  EXPECT_EQ(m.mat.value, 7);
  EXPECT_EQ((V{m.vx.value, m.vy.value, m.tdot.value}), (V{3, 4, 5}));
}

TEST(Cards, JointHasStrengthAndStiffness) {
  const auto j = card<Joint>("JOINT, 7, .8, 2, 1, .5, .3, .2, 10,\n.05, 6, 9\n");
  EXPECT_EQ(j.id.value, 7);
  EXPECT_EQ(
      (V{j.fric.value, j.coh.value, j.ten.value, j.fricr.value, j.cohr.value,
         j.tenr.value, j.dil.value.value(), j.zdil.value, j.kn.value, j.ks.value}),
      (V{.8, 2, 1, .5, .3, .2, 10, .05, 6, 9}));
  const auto bare = card<Joint>("JOINT, 7, .8\n");
  EXPECT_EQ((V{bare.coh.value, bare.ten.value, bare.fricr.value, bare.cohr.value,
               bare.tenr.value, bare.dil.value.value(), bare.kn.value, bare.ks.value}),
            (V{0, 0, .8, 0, 0, 0, 0, 0}));
  EXPECT_FALSE(bare.zdil.given);
  EXPECT_EQ(card<Joint>("JOINT, 7, , , , , , , , , 3\n").ks.value, 3);
}

TEST(Cards, WaltonAndBartonNameAJoint) {
  const auto w = card<Walton>("WALTON, 7, .6\n");
  EXPECT_EQ(w.id.value, 7);
  EXPECT_EQ(w.e.value, .6);
  EXPECT_EQ(card<Walton>("WALTON, 7\n").e.value, 1);
  const auto b = card<Barton>("BARTON, 7, 10, 2, 30, 4, 5, 6, 8\n");
  EXPECT_EQ(b.id.value, 7);
  EXPECT_EQ((V{b.jrc.value, b.jcs.value, b.phir.value, b.upeak.value, b.kni.value,
               b.vm.value, b.knmax.value}),
            (V{10, 2, 30, 4, 5, 6, 8}));
}

TEST(Cards, JpairNamesMaterialsAndBondAJoint) {
  const auto p = card<Jpair>("JPAIR, 3, 2, 7\n");
  EXPECT_EQ(p.mat1.value, 3);
  EXPECT_EQ(p.mat2.value, 2);
  EXPECT_EQ(p.id.value, 7);
  EXPECT_EQ(card<Bond>("BOND, 7, .5\n").tol.value, .5);
  EXPECT_EQ(card<Bond>("BOND\n").id.value, 0);
  EXPECT_FALSE(card<Bond>("BOND\n").tol.given);
}

TEST(Cards, DriveNamesABlock) {
  const auto d = card<Drive>("DRIVE, 7, 3, 4, 5\n");
  EXPECT_EQ(d.nb.number.value, 7);
  EXPECT_EQ((V{d.vx.value, d.vy.value, d.tdot.value}), (V{3, 4, 5}));
  EXPECT_EQ(card<Drive>("DRIVE, 7\n").vx.value, 0);
}

TEST(Cards, OutputNamesBlocks) {
  const auto o = card<Output>("OUTPUT, .1, 1, 5,\n9\n");
  EXPECT_EQ(o.dtout.value, .1);
  ASSERT_EQ(o.blocks.size(), 3U);
  EXPECT_EQ(o.blocks[2].number.value, 9);
  EXPECT_TRUE(card<Output>("OUTPUT, .1\n").blocks.empty());
}

TEST(Cards, RunsHaveATimeOrANumberOfSteps) {
  EXPECT_EQ(card<Plots>("PLOTS, .01\n").dtplot.value, .01);
  EXPECT_EQ(card<Motion>("MOTION, 1.D-3\n").dt.value, 1e-3);
  EXPECT_EQ(card<Cycle>("CYCLE, 1E3\n").ncycle.value, 1000);
  card<Dump>("DUMP\n");
  card<Stop>("STOP\n");
}

TEST(Cards, Read9MayNameAFile) {
  EXPECT_EQ(card<Read9>("READ9, Mine.msh\n").file.value, "Mine.msh");
  EXPECT_EQ(card<Read9>("READ9\n").file.value, "tape9");
  EXPECT_FALSE(card<Read9>("READ9\n").file.given);
}

TEST(Cards, RestartMayNameACheckpoint) {
  const Parsed p = parse_text("restart, \"my run.ckpt.h5\"\ncycle, 3\n");
  EXPECT_EQ(p.messages, "");
  EXPECT_EQ(p.only<Restart>().file.value, "my run.ckpt.h5");
  EXPECT_FALSE(parse_text("RESTART\n").only<Restart>().file.given);
}

}  // namespace
}  // namespace blocks::deck
