#include <bounce/part3_step.hpp>
#include <bounce/part4_simulate.hpp>
#include <thread>

namespace bounce {

namespace {

class Recorder {
 public:
  explicit Recorder(int columns) : size_(columns) {
    film_.q.resize(3, columns);
    film_.v.resize(3, columns);
  }

  bool full() const { return used_ == size_; }

  void add(const State& s) {
    film_.q.col(used_) = s.q;
    film_.v.col(used_) = s.v;
    ++used_;
  }

  const Trajectory& film() const { return film_; }

 private:
  int size_;
  int used_ = 0;
  Trajectory film_;
};

}  // namespace

Trajectory simulate(const Vector3& q_0, const Vector3& v_0, const Parameters& params) {
  Recorder recorder(params.T);
  std::thread worker([&] {
    State s{q_0, v_0};
    recorder.add(s);
    while (!recorder.full()) {
      s = step(s.q, s.v, params);
      recorder.add(s);
    }
  });
  worker.join();
  return recorder.film();
}

}  // namespace bounce
