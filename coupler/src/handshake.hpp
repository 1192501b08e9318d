// The first exchange: version, scene, facts, fields. Whatever differs is refused before a window.
#pragma once

#include "layout.hpp"
#include "session_impl.hpp"

namespace slidewave {

/// What this side tells the other.
struct Hello {
  std::vector<Field> offers;
  std::vector<Feature> features;
  Box bounds;
};

/// What both sides know after it.
struct Agreed {
  Models models;
  Layout layout;
  Vec3 in_plane = Vec3::Ones();   ///< 0 along an axis that the fluid does not solve ('e')
  bool saturation = false;        ///< the fluid engine tells where air is
  std::vector<Box> fluid_boxes;   ///< per fluid rank
  std::vector<Feature> features;  ///< models, then fluid engine, then particle engine
};

/// Fails with status 2 and one table where the sides disagree, or a need is not offered.
Agreed handshake(Session::Impl& session, Hello const& mine);

/// Throws std::runtime_error naming the model whose need is not among the offers.
void check_needs(Models const& models, std::vector<Field> const& offers);

/// The same for what a particle engine must gather and take beyond what every scene needs: throws
/// InputError.
void check_particle_needs(Models const& models, ParticleEngine const& engine);

/// The start-up table: what is active, what is left out and why, and the layout.
std::string describe(Agreed const& agreed);

}  // namespace slidewave
