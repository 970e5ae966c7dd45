#include "physics/body_symbols.h"

namespace physics {

BodySymbols movingBody(Graph& g, const std::string& name, bool isSpinInWorldAxes) {
    const auto symbol = [&](const char* quantity) { return g.symbol(name + "." + quantity); };
    BodySymbols body;
    body.position = {symbol("x"), symbol("y"), symbol("z")};
    body.velocity = {symbol("dx"), symbol("dy"), symbol("dz")};
    body.attitude = {symbol("qw"), symbol("qx"), symbol("qy"), symbol("qz")};
    body.isSpinInWorldAxes = isSpinInWorldAxes;
    body.spin = isSpinInWorldAxes ? NodeVector{symbol("wx"), symbol("wy"), symbol("wz")}
                                  : NodeVector{symbol("w1"), symbol("w2"), symbol("w3")};
    body.rotation = rotationMatrix(g, body.attitude);
    return body;
}

BodySymbols fixedBody(Graph& g, const geometry::Pose& centreOfMass) {
    const Matrix rotation = centreOfMass.attitude.toRotationMatrix();
    const Quaternion& q = centreOfMass.attitude;
    BodySymbols body;
    body.position = constant(g, centreOfMass.position);
    body.velocity = body.spin = constant(g, Vector::Zero());
    body.attitude = {g.constant(q.w()), g.constant(q.x()), g.constant(q.y()), g.constant(q.z())};
    for (int row = 0; row < 3; ++row)
        body.rotation[static_cast<std::size_t>(row)] = constant(g, rotation.row(row));
    return body;
}

} // namespace physics
