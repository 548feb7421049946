#pragma once
/// The names of CLI11, whose headers take about as long to compile as a whole command: for headers of the program.

namespace CLI {
class App;
class Option;
}  // namespace CLI
