#include "peers.h"

namespace lambert::bench {

std::vector<Peer> other_peers() {
  std::vector<Peer> peers;
#ifdef LAMBERT_HAS_CLIPPER
  peers.push_back(clipper_peer());
#endif
#ifdef LAMBERT_HAS_BOOST
  peers.push_back(boost_peer());
#endif
#ifdef LAMBERT_HAS_CGAL
  peers.push_back(cgal_peer());
#endif
  return peers;
}

}  // namespace lambert::bench
