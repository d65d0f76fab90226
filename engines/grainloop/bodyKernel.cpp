#include <grainloop/bodyKernel.hpp>

#include <algorithm>
#include <cmath>

#include <grainloop/processor.hpp>
#include <physics/motion.hpp>

namespace grus::grainloop {

namespace {

constexpr int bodyBlock = 64;

/// Loads on the bodies of a block, and what moving them gives.
struct Block {
    double fx[bodyBlock], fy[bodyBlock], fz[bodyBlock], mx[bodyBlock], my[bodyBlock], mz[bodyBlock];
    double damped[bodyBlock], gravity[bodyBlock], speed[bodyBlock];
    double r[9][bodyBlock]; ///< rotation matrices, row by row; in the plane cosine and sine
};

/// Adds what one thread has summed.
template <int dim>
inline void gather(const Bodies& b, const Elements& e, const double* forces, Forces::Range range, int begin, int end,
                   Block& out) {
    constexpr std::size_t stride = Forces::stride(dim);
    for (int k = begin, s = 0; k < end; ++k, ++s) {
        const int from = std::max(b.begin[k], range.begin), to = std::min(b.begin[k + 1], range.end);
        const double x = b.position.x[k], y = b.position.y[k], z = b.position.z[k];
        for (int i = from; i < to; ++i) {
            const double* f = forces + i * stride;
            const double ax = e.position.x[i] - x, ay = e.position.y[i] - y;
            out.fx[s] += f[0];
            out.fy[s] += f[1];
            if (dim == 2) {
                out.mz[s] += f[2] + (ax * f[1] - ay * f[0]);
                continue;
            }
            const double az = e.position.z[i] - z;
            out.fz[s] += f[2];
            out.mx[s] += f[3] + (ay * f[2] - az * f[1]);
            out.my[s] += f[4] + (az * f[0] - ax * f[2]);
            out.mz[s] += f[5] + (ax * f[1] - ay * f[0]);
        }
    }
}

template <int dim>
void loads(const Bodies& b, const Elements& e, const Forces& forces, int begin, int end, Block& out) {
    for (double* v : {out.fx, out.fy, out.fz, out.mx, out.my, out.mz})
        std::fill(v, v + (end - begin), 0.0);
    for (int t = 0; t < forces.threads(); ++t)
        gather<dim>(b, e, forces.data(t), forces.range[t], begin, end, out);
}

/// One component of the velocity, or of the angular velocity of a body whose rotation is integrated by it.
[[gnu::always_inline]] inline double faster(double v, double load, double mass, double gravity, double free,
                                            double damping, double dt) {
    const double a = free * (load / mass + gravity);
    return v + dt * physics::damped(a, v, damping, dt);
}

/// Power that damping takes from a component of the motion, over the damping; none from one that is prescribed.
[[gnu::always_inline]] inline double taken(double v, double load, double free) {
    return free * std::abs(v) * std::abs(load);
}

struct PlaneView {
    double* __restrict__ x, * __restrict__ y, * __restrict__ vx, * __restrict__ vy, * __restrict__ w;
    double* __restrict__ qw, * __restrict__ qz;
    const double* __restrict__ mass, * __restrict__ inertia, * __restrict__ freeX, * __restrict__ freeY, * __restrict__ freeTurn, * __restrict__ damped, * __restrict__ reach;
};

[[gnu::always_inline]] inline void movePlaneBody(const PlaneView& v, const Motion& m, int begin, int end, Block& out) {
    const double dt = m.dt, gx = m.gravity.x(), gy = m.gravity.y();
#pragma omp simd
    for (int k = begin; k < end; ++k) {
        const int s = k - begin;
        const double damping = m.damping * v.damped[k];
        out.damped[s] =
            damping * dt *
            (taken(v.vx[k], out.fx[s] + v.mass[k] * gx, v.freeX[k]) +
             taken(v.vy[k], out.fy[s] + v.mass[k] * gy, v.freeY[k]) + taken(v.w[k], out.mz[s], v.freeTurn[k]));
        out.gravity[s] = -dt * v.mass[k] * (gx * v.vx[k] + gy * v.vy[k]);
        const double vx = faster(v.vx[k], out.fx[s], v.mass[k], gx, v.freeX[k], damping, dt);
        const double vy = faster(v.vy[k], out.fy[s], v.mass[k], gy, v.freeY[k], damping, dt);
        const double w = faster(v.w[k], out.mz[s], v.inertia[k], 0, v.freeTurn[k], damping, dt);
        v.vx[k] = vx;
        v.vy[k] = vy;
        v.w[k] = w;
        v.x[k] += dt * vx;
        v.y[k] += dt * vy;
        const double half = 0.5 * dt * w, sine = physics::smallSine(half), cosine = physics::smallCosine(half);
        const double qw = cosine * v.qw[k] - sine * v.qz[k], qz = cosine * v.qz[k] + sine * v.qw[k];
        const double norm = 1 / std::sqrt(qw * qw + qz * qz);
        v.qw[k] = qw * norm;
        v.qz[k] = qz * norm;
        out.r[0][s] = v.qw[k] * v.qw[k] - v.qz[k] * v.qz[k];
        out.r[1][s] = 2 * v.qw[k] * v.qz[k];
        const double speed = std::sqrt(vx * vx + vy * vy) + std::abs(w) * v.reach[k];
        out.speed[s] = speed * speed;
    }
}

GRUS_FOR_EACH_PROCESSOR(movePlane, (const PlaneView& v, const Motion& m, int begin, int end, Block& out), movePlaneBody,
                        (v, m, begin, end, out))

struct PlaneElements {
    double* __restrict__ x, * __restrict__ y, * __restrict__ vx, * __restrict__ vy, * __restrict__ w;
    const int* __restrict__ body;
    const double* __restrict__ placeX, * __restrict__ placeY;
};

[[gnu::always_inline]] inline void placePlaneBody(const PlaneElements& e, const PlaneView& v, const Block& block,
                                                  int firstBody, int begin, int end) {
#pragma omp simd
    for (int i = begin; i < end; ++i) {
        const int k = e.body[i], s = k - firstBody;
        const double c = block.r[0][s], t = block.r[1][s];
        const double ax = c * e.placeX[i] - t * e.placeY[i], ay = t * e.placeX[i] + c * e.placeY[i];
        e.x[i] = v.x[k] + ax;
        e.y[i] = v.y[k] + ay;
        e.vx[i] = v.vx[k] - v.w[k] * ay;
        e.vy[i] = v.vy[k] + v.w[k] * ax;
        e.w[i] = v.w[k];
    }
}

GRUS_FOR_EACH_PROCESSOR(placePlane,
                        (const PlaneElements& e, const PlaneView& v, const Block& block, int firstBody, int begin,
                         int end),
                        placePlaneBody, (e, v, block, firstBody, begin, end))

struct SpaceView {
    Components<double> position, velocity, rate, momentum;
    double* __restrict__ qw, * __restrict__ qx, * __restrict__ qy, * __restrict__ qz;
    Components<const double> inertia, free, freeTurn;
    const double* __restrict__ mass, * __restrict__ damped, * __restrict__ reach;
};

template <bool aspherical>
[[gnu::always_inline]] inline void moveSpace(const SpaceView& v, const Motion& m, int k, int s, Block& out) {
    using namespace physics;
    const double dt = m.dt, damping = m.damping * v.damped[k], mass = v.mass[k];
    const Vec3 force(out.fx[s], out.fy[s], out.fz[s]), moment(out.mx[s], out.my[s], out.mz[s]);
    Vec3 velocity = polar<3>(v.velocity, k), rate = axial<3>(v.rate, k);
    const Vec3 free = polar<3>(v.free, k), freeTurn = axial<3>(v.freeTurn, k), inertia = axial<3>(v.inertia, k);
    out.damped[s] =
        damping * dt *
        (taken(velocity[0], force[0] + mass * m.gravity[0], free[0]) +
         taken(velocity[1], force[1] + mass * m.gravity[1], free[1]) +
         taken(velocity[2], force[2] + mass * m.gravity[2], free[2]) + taken(rate[0], moment[0], freeTurn[0]) +
         taken(rate[1], moment[1], freeTurn[1]) + taken(rate[2], moment[2], freeTurn[2]));
    out.gravity[s] = -dt * mass * m.gravity.dot(velocity);
    velocity = {faster(velocity[0], force[0], mass, m.gravity[0], free[0], damping, dt),
                faster(velocity[1], force[1], mass, m.gravity[1], free[1], damping, dt),
                faster(velocity[2], force[2], mass, m.gravity[2], free[2], damping, dt)};
    Quat q(v.qw[k], v.qx[k], v.qy[k], v.qz[k]);
    if (aspherical) {
        const Vec3 acting(freeTurn[0] * moment[0] * (1 - damping * sign(moment[0] * rate[0])),
                          freeTurn[1] * moment[1] * (1 - damping * sign(moment[1] * rate[1])),
                          freeTurn[2] * moment[2] * (1 - damping * sign(moment[2] * rate[2])));
        Vec3 momentum = axial<3>(v.momentum, k);
        turnAspherical(q, momentum, rate, acting, inertia, dt);
        setAxial<3>(v.momentum, k, momentum);
    } else {
        rate = {faster(rate[0], moment[0], inertia[0], 0, freeTurn[0], damping, dt),
                faster(rate[1], moment[1], inertia[1], 0, freeTurn[1], damping, dt),
                faster(rate[2], moment[2], inertia[2], 0, freeTurn[2], damping, dt)};
        q = turned(q, rate, dt);
    }
    setPolar<3>(v.velocity, k, velocity);
    setPolar<3>(v.position, k, polar<3>(v.position, k) + dt * velocity);
    setAxial<3>(v.rate, k, rate);
    v.qw[k] = q.w();
    v.qx[k] = q.x();
    v.qy[k] = q.y();
    v.qz[k] = q.z();
    const double speed = velocity.norm() + rate.norm() * v.reach[k];
    out.speed[s] = speed * speed;
    const double w = q.w(), x = q.x(), y = q.y(), z = q.z();
    out.r[0][s] = 1 - 2 * (y * y + z * z);
    out.r[1][s] = 2 * (x * y - w * z);
    out.r[2][s] = 2 * (x * z + w * y);
    out.r[3][s] = 2 * (x * y + w * z);
    out.r[4][s] = 1 - 2 * (x * x + z * z);
    out.r[5][s] = 2 * (y * z - w * x);
    out.r[6][s] = 2 * (x * z - w * y);
    out.r[7][s] = 2 * (y * z + w * x);
    out.r[8][s] = 1 - 2 * (x * x + y * y);
}

template <bool aspherical>
[[gnu::always_inline]] inline void moveSpaceBody(const SpaceView& v, const Motion& m, int first, int begin, int end,
                                                 Block& out) {
#pragma omp simd
    for (int k = begin; k < end; ++k)
        moveSpace<aspherical>(v, m, k, k - first, out);
}

GRUS_FOR_EACH_PROCESSOR(moveSpherical, (const SpaceView& v, const Motion& m, int first, int begin, int end, Block& out),
                        moveSpaceBody<false>, (v, m, first, begin, end, out))
GRUS_FOR_EACH_PROCESSOR(moveAspherical,
                        (const SpaceView& v, const Motion& m, int first, int begin, int end, Block& out),
                        moveSpaceBody<true>, (v, m, first, begin, end, out))

struct SpaceElements {
    Components<double> position, velocity, rate;
    const int* __restrict__ body;
    Components<const double> place, centre, bodyVelocity, bodyRate;
};

[[gnu::always_inline]] inline void placeSpaceBody(const SpaceElements& e, const Block& block, int firstBody, int begin,
                                                  int end) {
#pragma omp simd
    for (int i = begin; i < end; ++i) {
        const int k = e.body[i], s = k - firstBody;
        const double px = e.place.x[i], py = e.place.y[i], pz = e.place.z[i];
        const double ax = block.r[0][s] * px + block.r[1][s] * py + block.r[2][s] * pz;
        const double ay = block.r[3][s] * px + block.r[4][s] * py + block.r[5][s] * pz;
        const double az = block.r[6][s] * px + block.r[7][s] * py + block.r[8][s] * pz;
        const double wx = e.bodyRate.x[k], wy = e.bodyRate.y[k], wz = e.bodyRate.z[k];
        e.position.x[i] = e.centre.x[k] + ax;
        e.position.y[i] = e.centre.y[k] + ay;
        e.position.z[i] = e.centre.z[k] + az;
        e.velocity.x[i] = e.bodyVelocity.x[k] + (wy * az - wz * ay);
        e.velocity.y[i] = e.bodyVelocity.y[k] + (wz * ax - wx * az);
        e.velocity.z[i] = e.bodyVelocity.z[k] + (wx * ay - wy * ax);
        e.rate.x[i] = wx;
        e.rate.y[i] = wy;
        e.rate.z[i] = wz;
    }
}

GRUS_FOR_EACH_PROCESSOR(placeSpace, (const SpaceElements& e, const Block& block, int firstBody, int begin, int end),
                        placeSpaceBody, (e, block, firstBody, begin, end))

void moveBlock2(Bodies& b, Elements& e, const Motion& m, int begin, int end, Block& block) {
    const PlaneView view{b.position.x.data(), b.position.y.data(), b.velocity.x.data(), b.velocity.y.data(),
                         b.rate.z.data(),     b.qw.data(),         b.qz.data(),         b.mass.data(),
                         b.inertia.z.data(),  b.free.x.data(),     b.free.y.data(),     b.freeTurn.z.data(),
                         b.damped.data(),     b.reach.data()};
    movePlane(view, m, begin, end, block);
    const PlaneElements elements{e.position.x.data(), e.position.y.data(), e.velocity.x.data(), e.velocity.y.data(),
                                 e.rate.z.data(),     e.body.data(),       b.place.x.data(),    b.place.y.data()};
    placePlane(elements, view, block, begin, b.begin[begin], b.begin[end]);
}

void moveBlock3(Bodies& b, Elements& e, const Motion& m, int begin, int end, Block& block) {
    const Bodies& from = b;
    const SpaceView view{components(b.position),
                         components(b.velocity),
                         components(b.rate),
                         components(b.momentum),
                         b.qw.data(),
                         b.qx.data(),
                         b.qy.data(),
                         b.qz.data(),
                         components(from.inertia),
                         components(from.free),
                         components(from.freeTurn),
                         b.mass.data(),
                         b.damped.data(),
                         b.reach.data()};
    const int middle = std::clamp(b.aspherical, begin, end);
    moveSpherical(view, m, begin, begin, middle, block);
    moveAspherical(view, m, begin, middle, end, block);
    const SpaceElements elements{
        components(e.position), components(e.velocity),    components(e.rate),        e.body.data(),
        components(from.place), components(from.position), components(from.velocity), components(from.rate)};
    placeSpace(elements, block, begin, b.begin[begin], b.begin[end]);
}

}

Moved moveBodies(int dim, Bodies& b, Elements& e, const Forces& forces, const Motion& m, int begin, int end) {
    Moved moved;
    Block block;
    for (int from = begin; from < end; from += bodyBlock) {
        const int to = std::min(end, from + bodyBlock);
        (dim == 2 ? loads<2> : loads<3>)(b, e, forces, from, to, block);
        (dim == 2 ? moveBlock2 : moveBlock3)(b, e, m, from, to, block);
        for (int s = 0; s < to - from; ++s) {
            moved.dampedEnergy += block.damped[s];
            moved.gravityWork += block.gravity[s];
            moved.fastestSquare = std::max(moved.fastestSquare, block.speed[s]);
        }
    }
    return moved;
}

void bodyLoad(const Bodies& b, const Elements& e, const Forces& forces, int k, Vec3& force, Vec3& moment) {
    force = moment = Vec3::Zero();
    for (int i = b.begin[k]; i < b.begin[k + 1]; ++i) {
        const Vec3 f = forces.force(i);
        force += f;
        moment += forces.moment(i) + physics::cross(e.position[i] - b.position[k], f);
    }
}

}
