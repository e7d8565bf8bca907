#include "engine.hpp"

namespace bounce::study {

Peers all_peers() {
  Peers all;
  for (Peers (*const engine)() : std::initializer_list<Peers (*)()>{
#ifdef BOUNCE_PEER_CHIPMUNK
           chipmunk,
#endif
#ifdef BOUNCE_PEER_BOX2D
           box2d,
#endif
#ifdef BOUNCE_PEER_ODE
           ode,
#endif
#ifdef BOUNCE_PEER_BULLET
           bullet,
#endif
#ifdef BOUNCE_PEER_MUJOCO
           mujoco,
#endif
#ifdef BOUNCE_PEER_DART
           dart,
#endif
#ifdef BOUNCE_PEER_SICONOS_KERNEL
           siconos_kernel,
#endif
#ifdef BOUNCE_PEER_SIMBODY
           simbody,
#endif
           numpy,
       }) {
    for (const Peer& peer : engine()) all.push_back(peer);
  }
  return all;
}

}  // namespace bounce::study
