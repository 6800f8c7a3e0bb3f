#include "monodromy/transitions.hpp"

namespace kov::monodromy {

bool Transitions::Before::operator()(const Point& a, const Point& b) const {
  return a.x < b.x || (!(b.x < a.x) && a.y < b.y);
}

void Transitions::announce(const Path& path) {
  for (std::size_t k = 0; k < path.joints.size(); ++k)
    for (const std::size_t vertex : {k, k + 1})
      values_[path.vertices[vertex]].emplace(path.joints[k], BallMatrix());
}

void Transitions::compute() {
  for (auto& [vertex, joints] : values_) {
    budget_.check();
    std::vector<ComplexBall> ends;
    for (const auto& [joint, value] : joints)
      ends.push_back(exact(joint));
    std::vector<BallMatrix> y = values(system_, exact(vertex), ends, bits_, budget_);
    std::size_t next = 0;
    for (auto& [joint, value] : joints)
      value = std::move(y[next++]);
  }
}

BallMatrix Transitions::along(const Path& path, BallMatrix start) const {
  BallMatrix product = std::move(start);
  for (std::size_t k = 0; k < path.joints.size(); ++k) {
    const Point& joint = path.joints[k];
    const BallMatrix& from = values_.at(path.vertices[k]).at(joint);
    const BallMatrix& to = values_.at(path.vertices[k + 1]).at(joint);
    product = multiply(inverse(to, bits_), multiply(from, product, bits_), bits_);
  }
  return product;
}

} // namespace kov::monodromy
