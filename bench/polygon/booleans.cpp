/// usage: bench_booleans [--tsv FILE] [--countries FILE] [--largest EDGES] [--slow]: times our booleans side by side
/// with the libraries that were found, on families of random polygons and on country outlines. Every time is the best
/// of several runs; a library is left out of larger sizes once a run has taken 2 s, unless --slow is given. Areas are
/// compared.

#include "families.h"
#include "peers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

namespace {

using namespace lambert;
using namespace lambert::bench;

struct Options {
  std::string tsv, countries;
  std::size_t largest = 100'000;
  bool slow = false;
};

constexpr double patience = 2;

Run best_run(Operands& operands, polygon::BooleanOp op) {
  Run best = operands.run(op);
  double spent = best.seconds;
  for (int i = 0; i < 200 && (i < 4 || spent < 0.3) && spent < patience; ++i) {
    const Run run = operands.run(op);
    spent += run.seconds;
    if (run.seconds < best.seconds) best = run;
  }
  return best;
}

/// Times add up over several pairs of operands: one for the random families, one a country for outlines.
class Table {
 public:
  explicit Table(const Options& options) : options_(options), peers_(other_peers()) {
    peers_.insert(peers_.begin(), lambert_peer());
    if (!options.tsv.empty()) {
      file_ = std::fopen(options.tsv.c_str(), "w");
      std::fprintf(file_, "family\tedges\toperation\tlibrary\tseconds\n");
    }
    std::printf("%-12s%9s  %-13s", "family", "edges", "operation");
    for (const Peer& peer : peers_) std::printf("%12s", peer.name.c_str());
    std::printf("   milliseconds\n");
  }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  ~Table() {
    if (file_ != nullptr) std::fclose(file_);
  }

  void add(const std::string& family, const std::vector<Pair>& pairs) {
    constexpr std::pair<polygon::BooleanOp, const char*> operations[]{{polygon::BooleanOp::intersect, "intersection"},
                                                                      {polygon::BooleanOp::unite, "union"}};
    std::size_t edges = 0;
    for (const Pair& pair : pairs) edges += edge_count(pair.subject) + edge_count(pair.clip);
    for (const auto& [op, name] : operations) {
      std::printf("%-12s%9zu  %-13s", family.c_str(), edges, name);
      double ours = 0;
      for (const Peer& peer : peers_) {
        double& slowest = slowest_[family + name + peer.name];
        if (slowest > patience && !options_.slow) {
          std::printf("%12s", "-");
          continue;
        }
        const Run sum = run_all(peer, pairs, op);
        if (sum.seconds == 0) {
          std::printf("%12s", "refuses");
          continue;
        }
        slowest = sum.seconds;
        if (&peer == peers_.data()) ours = sum.area;
        const bool differs = std::abs(sum.area - ours) > 1e-5 * std::abs(ours);
        std::printf("%11.3f%c", 1e3 * sum.seconds, differs ? '!' : ' ');
        std::fflush(stdout);
        differ_ |= differs;
        if (file_ != nullptr)
          std::fprintf(file_, "%s\t%zu\t%s\t%s\t%.9g\n", family.c_str(), edges, name, peer.name.c_str(), sum.seconds);
      }
      std::printf("\n");
    }
  }

  bool areas_differ() const { return differ_; }

 private:
  static Run run_all(const Peer& peer, const std::vector<Pair>& pairs, polygon::BooleanOp op) {
    Run sum;
    for (const Pair& pair : pairs) {
      const std::unique_ptr<Operands> operands = peer.prepare(pair.subject, pair.clip);
      if (operands == nullptr) return {};
      const Run run = best_run(*operands, op);
      sum.seconds += run.seconds;
      sum.area += run.area;
    }
    return sum;
  }

  Options options_;
  std::vector<Peer> peers_;
  std::map<std::string, double> slowest_;
  std::FILE* file_ = nullptr;
  bool differ_ = false;
};

polygon::Rings moved(polygon::Rings rings, Vec2d by) {
  for (polygon::Ring& ring : rings) {
    for (Vec2d& p : ring) p = p + by;
  }
  return rings;
}

/// Each country with itself moved by two degrees, and the land of the whole world with itself moved, refined to sizes.
void add_countries(Table& table, const Options& options) {
  const std::vector<polygon::Rings> outlines = countries(options.countries);
  std::vector<Pair> each;
  for (const polygon::Rings& rings : outlines) each.push_back({rings, moved(rings, {0.013, 0.007})});
  table.add("countries", each);
  for (const std::size_t edges : {10'000UL, 30'000UL, 60'000UL, 100'000UL}) {
    if (edges > options.largest) continue;
    const polygon::Rings land = refined_land(outlines, edges / 2);
    table.add("land", {{land, moved(land, {0.013, 0.007})}});
  }
}

Options parse(int count, char** arguments) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string word = arguments[i];
    if (word == "--slow") options.slow = true;
    if (i + 1 == count) break;
    if (word == "--tsv") options.tsv = arguments[++i];
    if (word == "--countries") options.countries = arguments[++i];
    if (word == "--largest") options.largest = std::stoul(arguments[++i]);
  }
  return options;
}

}  // namespace

int main(int count, char** arguments) {
  const Options options = parse(count, arguments);
  Table table(options);
  for (const Family& family : families()) {
    for (const std::size_t edges : {1'000UL, 2'000UL, 5'000UL, 10'000UL, 20'000UL, 50'000UL, 100'000UL}) {
      if (edges <= options.largest) table.add(family.name, {family.make(edges)});
    }
  }
  if (options.countries.empty()) {
    std::printf("no --countries FILE (world-atlas countries-110m.json): outlines are not measured\n");
  } else {
    add_countries(table, options);
  }
  if (table.areas_differ())
    std::printf(
        "! the area differs from ours by more than 1e-5 (country outlines are not all valid, for those who demand "
        "that)\n");
  return 0;
}
