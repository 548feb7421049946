#pragma once
#include <vector>

namespace lambert::tone {

/// Solves the five-point Poisson equation with Neumann boundaries on a grid of width x height cells of side 1: the sum
/// over the neighbours n of cell c of u_n - u_c is divergence_c. The divergence must sum to 0 (what it does not is
/// spread evenly); the solution has the mean 0. Cell-centred multigrid, V-cycles until the residual is below 1e-7 of
/// the largest divergence (at most 40); about 8 cycles whatever the size.
std::vector<double> solve_poisson(int width, int height, std::vector<double> divergence);

}  // namespace lambert::tone
