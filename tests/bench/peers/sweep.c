/* Position, velocity and acceleration of all links and points of three mechanisms, as one writes it by hand.
 *
 * Every function takes sizes [m], crank angles [rad] (n), the crank's omega and alpha, and writes columns of n
 * doubles: x, y, vx, vy, ax, ay of each point, then value, rate and acceleration of each angle and displacement.
 */
#include <math.h>

typedef struct { double x, y; } vec;

static inline vec add(vec a, vec b) { return (vec){a.x + b.x, a.y + b.y}; }
static inline vec sub(vec a, vec b) { return (vec){a.x - b.x, a.y - b.y}; }
static inline vec times(double k, vec a) { return (vec){k * a.x, k * a.y}; }
static inline vec left(vec a) { return (vec){-a.y, a.x}; }
static inline double dot(vec a, vec b) { return a.x * b.x + a.y * b.y; }
static inline double cross(vec a, vec b) { return a.x * b.y - a.y * b.x; }
static inline vec turned(vec arm, double omega) { return times(omega, left(arm)); }
static inline vec bent(vec arm, double omega, double alpha) {
    return add(times(alpha, left(arm)), times(-omega * omega, arm));
}

typedef struct { vec at, v, a; } point;
typedef struct { double value, rate, acceleration; } turn;

static inline void put_point(double *out, long n, long i, point p) {
    out[i] = p.at.x; out[n + i] = p.at.y; out[2 * n + i] = p.v.x;
    out[3 * n + i] = p.v.y; out[4 * n + i] = p.a.x; out[5 * n + i] = p.a.y;
}

static inline void put_turn(double *out, long n, long i, turn t) {
    out[i] = t.value; out[n + i] = t.rate; out[2 * n + i] = t.acceleration;
}

static inline point crank(vec pivot, double length, double angle, double omega, double alpha) {
    vec arm = {length * cos(angle), length * sin(angle)};
    return (point){add(pivot, arm), turned(arm, omega), bent(arm, omega, alpha)};
}

static inline point carried(point on, vec arm, turn of) {
    return (point){add(on.at, arm), add(on.v, turned(arm, of.rate)),
                   add(on.a, bent(arm, of.rate, of.acceleration))};
}

/* A rod of a given length from a moving point to a fixed line: its end, its turning, and the way along the line. */
static inline void rod_to_line(point from, vec through, vec along, double length, double side,
                               point *end, turn *rod, turn *way) {
    vec gap = sub(through, from.at);
    double height = cross(along, gap);
    way->value = side * sqrt(length * length - height * height) - dot(gap, along);
    end->at = add(through, times(way->value, along));
    vec arm = sub(end->at, from.at);
    double share = 1.0 / dot(arm, along);
    rod->value = atan2(arm.y, arm.x);
    rod->rate = -cross(along, from.v) * share;
    way->rate = dot(from.v, arm) * share;
    end->v = times(way->rate, along);
    vec known = sub(from.a, times(rod->rate * rod->rate, arm));
    rod->acceleration = -cross(along, known) * share;
    way->acceleration = dot(known, arm) * share;
    end->a = times(way->acceleration, along);
}

/* sizes: A, D, AB, BC, DC, E along and across BC, side. Columns: B, C, E; links 2, 3. */
void four_bar(const double *s, const double *angle, double omega, double alpha, long n, double *out) {
    vec a = {s[0], s[1]}, d = {s[2], s[3]};
    double bc = s[5], dc = s[6], side = s[9];
    vec e_in_bc = {s[7] / bc, s[8] / bc};
    for (long i = 0; i < n; i++) {
        point b = crank(a, s[4], angle[i], omega, alpha), c;
        turn two, three;
        vec way = sub(d, b.at);
        double square = dot(way, way), share = (square + bc * bc - dc * dc) / (2 * square);
        double height = side * sqrt(bc * bc / square - share * share);
        vec rod = add(times(share, way), times(height, left(way)));
        c.at = add(b.at, rod);
        vec bar = sub(c.at, d);
        double lean = 1.0 / cross(rod, bar);
        two.value = atan2(rod.y, rod.x);
        three.value = atan2(bar.y, bar.x);
        two.rate = -dot(b.v, bar) * lean;
        three.rate = -dot(b.v, rod) * lean;
        vec known = add(sub(b.a, times(two.rate * two.rate, rod)), times(three.rate * three.rate, bar));
        two.acceleration = -dot(known, bar) * lean;
        three.acceleration = -dot(known, rod) * lean;
        c.v = turned(bar, three.rate);
        c.a = bent(bar, three.rate, three.acceleration);
        put_point(out, n, i, b);
        put_point(out + 6 * n, n, i, c);
        put_point(out + 12 * n, n, i, carried(b, add(times(e_in_bc.x, rod), times(e_in_bc.y, left(rod))), two));
        put_turn(out + 18 * n, n, i, two);
        put_turn(out + 21 * n, n, i, three);
    }
}

/* sizes: A, a point of the guide, its direction, AB, BC, side. Columns: B, C; link 2, displacement. */
void slider_crank(const double *s, const double *angle, double omega, double alpha, long n, double *out) {
    vec a = {s[0], s[1]}, through = {s[2], s[3]}, along = {s[4], s[5]};
    for (long i = 0; i < n; i++) {
        point b = crank(a, s[6], angle[i], omega, alpha), c;
        turn rod, way;
        rod_to_line(b, through, along, s[7], s[8], &c, &rod, &way);
        put_point(out, n, i, b);
        put_point(out + 6 * n, n, i, c);
        put_turn(out + 12 * n, n, i, rod);
        put_turn(out + 15 * n, n, i, way);
    }
}

/* sizes: A, C, a point of the ram's guide, its direction, AB, CD, DE, side.
 * Columns: B, D, E; bar 3, rod 4, ram, block 2 along the bar. */
void shaper(const double *s, const double *angle, double omega, double alpha, long n, double *out) {
    vec a = {s[0], s[1]}, c = {s[2], s[3]}, through = {s[4], s[5]}, along = {s[6], s[7]};
    for (long i = 0; i < n; i++) {
        point b = crank(a, s[8], angle[i], omega, alpha), e, fixed = {c, {0, 0}, {0, 0}};
        turn bar, rod, ram, block;
        vec arm = sub(b.at, c);
        block.value = sqrt(dot(arm, arm));
        vec axis = times(1.0 / block.value, arm);
        bar.value = atan2(arm.y, arm.x);
        bar.rate = cross(axis, b.v) / block.value;
        block.rate = dot(axis, b.v);
        bar.acceleration = (cross(axis, b.a) - 2 * block.rate * bar.rate) / block.value;
        block.acceleration = dot(axis, b.a) + block.value * bar.rate * bar.rate;
        point d = carried(fixed, times(s[9], axis), bar);
        rod_to_line(d, through, along, s[10], s[11], &e, &rod, &ram);
        put_point(out, n, i, b);
        put_point(out + 6 * n, n, i, d);
        put_point(out + 12 * n, n, i, e);
        put_turn(out + 18 * n, n, i, bar);
        put_turn(out + 21 * n, n, i, rod);
        put_turn(out + 24 * n, n, i, ram);
        put_turn(out + 27 * n, n, i, block);
    }
}
