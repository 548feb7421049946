# Triangulations side by side with CGAL, which is an oracle and linked here only.
find_package(CGAL QUIET)
add_executable(bench_triangulate polygon/triangulate.cpp)
target_link_libraries(bench_triangulate PRIVATE lambert_polygon lambert_options)
# As the polygon module itself: the polygons are made and checked by its predicates.
target_compile_options(bench_triangulate PRIVATE -ffp-contract=off)
if(CGAL_FOUND)
  # Compiled without our warnings, in a library of its own.
  add_library(bench_triangulate_cgal STATIC polygon/triangulate_cgal.cpp)
  target_compile_features(bench_triangulate_cgal PRIVATE cxx_std_20)
  target_compile_options(bench_triangulate_cgal PRIVATE -march=x86-64-v3)
  target_link_libraries(bench_triangulate_cgal PRIVATE lambert_polygon CGAL::CGAL)
  target_link_libraries(bench_triangulate PRIVATE bench_triangulate_cgal)
  target_compile_definitions(bench_triangulate PRIVATE LAMBERT_HAS_CGAL)
else()
  message(WARNING "TRIANGULATIONS ARE NOT MEASURED AGAINST CGAL: it was not found (libcgal-dev)")
endif()
