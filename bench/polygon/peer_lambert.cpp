#include "peers.h"
#include "stopwatch.h"

namespace lambert::bench {
namespace {

class OurOperands final : public Operands {
 public:
  OurOperands(const polygon::Rings& subject, const polygon::Rings& clip) : subject_(subject), clip_(clip) {}

  Run run(polygon::BooleanOp op) override {
    Stopwatch watch;
    const polygon::Regions result = polygon::boolean(op, subject_, clip_);
    Run run{.seconds = watch.seconds(), .area = polygon::area(result)};
    for (const polygon::Ring& ring : polygon::rings_of(result)) run.vertices += ring.size();
    return run;
  }

 private:
  polygon::Rings subject_, clip_;
};

}  // namespace

Peer lambert_peer() { return {"lambert", prepared<OurOperands>}; }

}  // namespace lambert::bench
