# lambert_read_layers(FILE): sets LAMBERT_MODULES (in order) and LAMBERT_LAYER_<module> (what it may use).
function(lambert_read_layers file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(STRINGS ${file} lines REGEX "^[a-z]+:")
  set(modules)
  foreach(line IN LISTS lines)
    string(REGEX MATCH "^([a-z]+):(.*)$" _ "${line}")
    set(name ${CMAKE_MATCH_1})
    separate_arguments(uses UNIX_COMMAND "${CMAKE_MATCH_2}")
    list(APPEND modules ${name})
    set(LAMBERT_LAYER_${name} ${uses} PARENT_SCOPE)
  endforeach()
  set(LAMBERT_MODULES ${modules} PARENT_SCOPE)
endfunction()

# lambert_module(NAME [LIBRARIES …]): every .cpp of the current folder (and of its folders) becomes the static
# library lambert_NAME; every *_test.cpp becomes part of lambert_NAME_test. The modules it links come from
# layers.txt; LIBRARIES are third-party ones, whose headers stay inside .cpp files.
function(lambert_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  set(tests ${sources})
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  list(FILTER tests INCLUDE REGEX "_test\\.cpp$")

  if(NOT sources)
    set(sources ${PROJECT_SOURCE_DIR}/cmake/empty.cpp)
  endif()
  add_library(lambert_${name} STATIC ${sources})
  add_library(lambert::${name} ALIAS lambert_${name})
  set_target_properties(lambert_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(lambert_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:include>)
  target_compile_features(lambert_${name} PUBLIC cxx_std_20)
  set(modules ${LAMBERT_LAYER_${name}})
  list(TRANSFORM modules PREPEND lambert_)
  target_link_libraries(lambert_${name} PUBLIC ${modules} glm::glm PRIVATE $<BUILD_INTERFACE:lambert_options> ${arg_LIBRARIES})

  set_property(GLOBAL APPEND PROPERTY LAMBERT_TESTS_SEEN ${tests})
  if(LAMBERT_TESTS AND tests)
    lambert_test(lambert_${name}_test ${tests} LIBRARIES lambert_${name} lambert_statistics ${arg_LIBRARIES})
  endif()
endfunction()

# lambert_test(TARGET SOURCES… LIBRARIES …): a GoogleTest program whose cases ctest lists one by one. GoogleTest's
# headers, a quarter of what compiling a test costs, are compiled once for all.
function(lambert_test target)
  if(NOT TARGET lambert_test_headers)
    add_library(lambert_test_headers OBJECT ${PROJECT_SOURCE_DIR}/cmake/empty.cpp)
    target_link_libraries(lambert_test_headers PRIVATE lambert_options GTest::gtest)
    set_target_properties(lambert_test_headers PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_precompile_headers(lambert_test_headers PRIVATE <gtest/gtest.h>)
  endif()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  add_executable(${target} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${target} PRIVATE ${arg_LIBRARIES} lambert_options GTest::gtest GTest::gtest_main)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)  # as the headers
  target_precompile_headers(${target} REUSE_FROM lambert_test_headers)
  # GCC 12 forgets that a precompiled header is a system's, and warns of its own std::string there
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow> $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds>)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/tests)
  target_compile_definitions(${target} PRIVATE
    LAMBERT_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    LAMBERT_SHARED_DATA="${PROJECT_SOURCE_DIR}/../shared/data")
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST PROPERTIES TIMEOUT 300)
endfunction()

# A *_test.cpp that no target compiles would never run: that is an error.
function(lambert_check_no_test_left_out)
  file(GLOB_RECURSE all CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*_test.cpp)
  get_property(seen GLOBAL PROPERTY LAMBERT_TESTS_SEEN)
  list(REMOVE_ITEM all ${seen})
  if(all)
    message(FATAL_ERROR "tests that no target compiles: ${all}")
  endif()
endfunction()
