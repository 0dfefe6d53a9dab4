#ifndef PACE_FORMAT_H
#define PACE_FORMAT_H

#include <boost/graph/adjacency_list.hpp>

#include <cstddef>
#include <iosfwd>
#include <vector>

typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                              boost::property<boost::edge_weight_t, double>> Graph;

struct Problem
{
  Graph graph;                     // of the vertices that have an edge or are terminals
  std::vector<std::size_t> names;  // their numbers in the file
  std::vector<std::size_t> terminals;
};

// reads a graph in the format of the PACE 2018 challenge; throws std::runtime_error, which says what is wrong
Problem read_problem(std::istream& in);

#endif // PACE_FORMAT_H
