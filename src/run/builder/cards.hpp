// What each card does to the model, by the files that define it. After an error of the
// card, the model is unchanged.
#pragma once

#include "deck/commands.hpp"
#include "run/builder/context.hpp"

namespace blocks::run {

// preliminary.cpp
void act(const Context&, const deck::Start&);
void act(const Context&, const deck::XLimits&);
void act(const Context&, const deck::YLimits&);
void act(const Context&, const deck::Boxes&);
void act(const Context&, const deck::Stiff&);
void act(const Context&, const deck::Frictn&);
void act(const Context&, const deck::Material&);
void act(const Context&, const deck::Rigid&);
void act(const Context&, const deck::Seed&);
void act(const Context&, const deck::Units&);
void act(const Context&, const deck::End&);

// blocks.cpp
void act(const Context&, const deck::Create&);
void act(const Context&, const deck::Read9&);

// layers.cpp
void act(const Context&, const deck::Orient&);
void act(const Context&, const deck::Merge&);
void act(const Context&, const deck::Layer&);

// cut.cpp
void act(const Context&, const deck::Cut&);

// planes.cpp
void act(const Context&, const deck::Splane&);

// velocities.cpp
void act(const Context&, const deck::Fix&);
void act(const Context&, const deck::SetVel&);
void act(const Context&, const deck::SetVelM&);
void act(const Context&, const deck::Drive&);
void act(const Context&, const deck::Servo&);

// excavation.cpp
void act(const Context&, const deck::Remove&);
void act(const Context&, const deck::Free&);

// loads.cpp
void act(const Context&, const deck::Gravity&);
void act(const Context&, const deck::Function&);
void act(const Context&, const deck::PressBc&);
void act(const Context&, const deck::Force&);

// water.cpp
void act(const Context&, const deck::Water&);
void act(const Context&, const deck::Jwater&);

// laws.cpp
void act(const Context&, const deck::Joint&);
void act(const Context&, const deck::Walton&);
void act(const Context&, const deck::Barton&);
void act(const Context&, const deck::Jpair&);
void act(const Context&, const deck::Bond&);

// damping.cpp
void act(const Context&, const deck::Fraction&);
void act(const Context&, const deck::Damping&);
void act(const Context&, const deck::Locdamp&);
void act(const Context&, const deck::Kindamp&);
void act(const Context&, const deck::Mdamp&);
void act(const Context&, const deck::Mscale&);

// in_situ.cpp
void act(const Context&, const deck::Insitu&);

// quiet.cpp
void act(const Context&, const deck::Quiet&);

// cracks.cpp
void act(const Context&, const deck::Crack&);

// output.cpp
void act(const Context&, const deck::Output&);
void act(const Context&, const deck::Plots&);
void act(const Context&, const deck::History&);

// steps.cpp
void act(const Context&, const deck::Motion&);
void act(const Context&, const deck::Cycle&);
void act(const Context&, const deck::Solve&);
void act(const Context&, const deck::Fos&);

// The run does what these cards want.
inline void act(const Context&, const deck::Restart&) {}
inline void act(const Context&, const deck::Dump&) {}
inline void act(const Context&, const deck::Save&) {}
inline void act(const Context&, const deck::Stop&) {}

}  // namespace blocks::run
