#include <bounce/part4_simulate.hpp>
#include <bounce/render.hpp>

int main() {
  const bounce::Parameters params;
  bounce::render(bounce::simulate({0, 1.5, 0.5}, {0, -0.2, 0}, params).q, params, "animation.html");
}
