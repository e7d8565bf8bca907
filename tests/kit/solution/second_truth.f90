! Reference simulator: rigid square on flat ground y=0 with Coulomb friction.
! Event-driven, quadruple precision.  Reads scenes
!   l mu epsilon g_x g_y x y theta v_x v_y omega until
! and prints  x y theta v_x v_y omega  at `until`, or  refused REASON.
! Optional arguments (for self-tests): Taylor order, Taylor tolerance, flat tolerance, Zeno cut.
! Chaotic scenes: run again with `60 1e-34`; digits that differ are beyond quadruple precision.
!
! Formulation: theta = k*pi/2 + tr with |tr| <= pi/4, so only two corners can be lowest:
! 0 (lower left, tr >= 0) and 1 (lower right, tr <= 0); corners are numbered counter-clockwise.
! While a corner touches, its height is 0 by definition and the other heights are taken relative
! to it (l sin tr, ...), so heights far below the rounding of y still mean something.
module world
  implicit none
  integer, parameter :: q = selected_real_kind(30), d8 = selected_real_kind(12)
  integer, parameter :: nmax = 80, flight = 0, corner = 1, side = 2
  real(q), parameter :: pi = 3.14159265358979323846264338327950288419716939937510_q
  real(q), parameter :: noise = 1.0e-29_q        ! speeds below noise*scale are zero
  ! numerical options
  integer :: order = 44
  real(q) :: taylor_tol = 1.0e-33_q, flat_tol = 1.0e-30_q, cut_factor = 1.0e-20_q
  ! a curve whose first descent to zero is sought: a polynomial, or the height of a flying corner
  type curve
    logical :: is_poly = .true.
    integer :: n = 0
    real(q) :: c(0:nmax) = 0, third = 0          ! third: bound of |f'''|
    real(q) :: h0 = 0, v = 0, g = 0, w = 0, rx = 0, ry = 0, vtiny = 0, atiny = 0
  end type
  ! scene and state
  real(q) :: l, mu, eps, gx, gy, rho2, until, cut, g_abs
  real(q) :: x, y, tr, vx, vy, om, t
  integer :: quarter, mode, sig, touching, impacts
  logical :: grounded                            ! a corner touches (or just left)
  character(16) :: reason
contains

  pure complex(q) function offset(j)              ! corner j from the centre, as x + i y
    integer, intent(in) :: j
    complex(q), parameter :: at_zero(0:3) = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    offset = 0.5_q*l*at_zero(j)*cmplx(cos(tr), sin(tr), q)
  end function

  pure real(q) function speed_scale()
    speed_scale = abs(vx) + abs(vy) + l*abs(om) + sqrt(g_abs*l)
  end function

  subroutine refuse(why)
    character(*), intent(in) :: why
    if (reason == '') reason = why
  end subroutine

  integer function normalise() result(n)          ! bring tr to [-pi/4, pi/4]; n quarter turns moved
    n = nint(tr/(0.5_q*pi))
    if (n /= 0) tr = tr - n*(0.5_q*pi)
    quarter = quarter + n
  end function

  ! ------------------------------------------------------------------ root finding
  subroutine eval(cv, s, f, f1, f2)
    type(curve), intent(in) :: cv
    real(q), intent(in) :: s
    real(q), intent(out) :: f, f1, f2
    real(q) :: sh, ch, sn, x1, y1
    integer :: k
    if (cv%is_poly) then
      f = cv%c(cv%n); f1 = 0; f2 = 0
      do k = cv%n - 1, 0, -1
        f2 = f2*s + f1; f1 = f1*s + f; f = f*s + cv%c(k)
      end do
      f2 = 2*f2
    else
      sh = sin(0.5_q*cv%w*s); ch = cos(0.5_q*cv%w*s); sn = 2*sh*ch
      x1 = cv%rx - 2*sh*sh*cv%rx - cv%ry*sn
      y1 = cv%ry - 2*sh*sh*cv%ry + cv%rx*sn
      f = cv%h0 + ((cv%v + 0.5_q*cv%g*s)*s + (cv%rx*sn - 2*sh*sh*cv%ry)) ! increments, not y + r_y
      f1 = cv%v + cv%g*s + cv%w*x1
      f2 = cv%g - cv%w**2*y1
    end if
  end subroutine

  ! Largest easily found s in (0, span] such that a0 + a1 s + a2 s^2 - a3 s^3 > 0 on (0, s), with
  ! a0, a3 >= 0: since the curve lies above this cubic, no root is skipped.
  subroutine safe_step(a0, a1, a2, a3, span, s, whole)
    real(d8), intent(in) :: a0, a1, a2, a3, span
    real(d8), intent(out) :: s
    logical, intent(out) :: whole
    real(d8) :: lo, hi, mid, disc, root, dip
    lo = 0; hi = span; disc = 4*a2*a2 + 12*a3*a1
    if (a1 >= 0 .or. (a2 > 0 .and. disc > 0)) then
      root = sqrt(disc); lo = span                ! local maximum of the cubic
      if (a2 < 0) then
        lo = min(span, 2*a1/(root - 2*a2))
      else if (6*a3*span > 2*a2 + root) then
        lo = (2*a2 + root)/(6*a3)
      end if
      if (a1 < 0) then
        dip = min(span, -2*a1/(2*a2 + root))      ! local minimum before it
        if (cubic(dip) <= 0) then
          lo = 0; hi = dip
        end if
      end if
    end if
    s = span; whole = lo >= span
    if (.not. whole .and. hi >= span) whole = cubic(span) > 0
    if (whole) return
    do while (hi - lo > 0.01_d8*lo .and. hi > 1.0e-60_d8)
      mid = merge(0.5_d8*(lo + hi), 0.05_d8*hi, lo > 0)
      if (cubic(mid) > 0) then
        lo = mid
      else
        hi = mid
      end if
    end do
    s = 0.99_d8*lo
  contains
    real(d8) function cubic(z)                    ! with a margin for double rounding
      real(d8), intent(in) :: z
      cubic = a0 + z*(a1 + z*(a2 - z*a3)) - 1.0e-13_d8*(a0 + z*(abs(a1) + z*(abs(a2) + z*a3)))
    end function
  end subroutine

  ! First s in [0, span) at which the curve descends through zero.
  subroutine first_root(cv, span, s, found)
    type(curve), intent(in) :: cv
    real(q), intent(in) :: span
    real(q), intent(out) :: s
    logical, intent(out) :: found
    real(q) :: f, f1, f2, ds, jerk, rest
    real(d8) :: step
    logical :: whole
    integer :: it, m, k
    s = 0; found = .false.
    do it = 1, 20000
      call eval(cv, s, f, f1, f2)
      if (s <= 0) then
        f = max(f, 0.0_q)
        if (f == 0 .and. abs(f1) <= cv%vtiny) f1 = 0
        if (f == 0 .and. f1 == 0 .and. abs(f2) <= cv%atiny) then
          ! leaves zero with a higher derivative only: the cubic bound needs a start
          if (cv%is_poly) then
            m = min(cv%n, count([(all(cv%c(0:k) == 0), k = 0, cv%n)]))   ! first that is not zero
            found = cv%c(m) < 0
            rest = sum([(abs(cv%c(k))*span**(k - m - 1), k = m + 1, cv%n)])
            if (found .or. 2*rest*span <= cv%c(m)) return
            s = 0.5_q*cv%c(m)/rest
          else
            if (cv%w == 0) return                 ! rests at the height of the ground, nothing bends it
            jerk = -cv%w**3*cv%rx
            if (jerk <= 0) call refuse('degenerate')
            s = 2*jerk/(cv%w**4*l)
          end if
          if (s >= span .or. reason /= '') return
          cycle
        end if
        found = f == 0 .and. (f1 < 0 .or. (f1 == 0 .and. f2 < 0))
        if (found) return
      else if (f <= 0) then
        if (f1 < 0) then
          s = s - f/f1; found = s < span; return
        end if
        f = 0                                     ! rounding only: steps are one-sided
      end if
      if (f1 < 0) then
        ds = -2*f/f1                              ! f' certainly changes by less than half on [0, ds]:
        if ((abs(f2) + cv%third*ds)*ds < -0.5_q*f1) then   ! plain Newton converges quadratically
          do k = 1, 12
            ds = -f/f1; s = s + ds
            if (abs(ds) <= 1.0e-34_q*s) exit
            call eval(cv, s, f, f1, f2)
          end do
          found = s < span; return
        end if
      end if
      call safe_step(real(f, d8), real(f1, d8), real(0.5_q*f2, d8), real(cv%third/6, d8)*1.0000001_d8, &
                     real(span - s, d8), step, whole)
      if (whole) return
      s = s + real(step, q)
      if (s >= span) return
    end do
    call refuse('grazing')
  end subroutine

  ! ------------------------------------------------------------------ complementarity
  ! w_i = bn_i + sum A f + b_i ft >= 0 complementary to f_i >= 0; ft within mu sum(f):
  ! stick (tangential part 0) or slide against direction sg.  fixed /= 0: known sliding direction.
  subroutine lcp(n, rx, ry, bn, bt, fixed, nsol, f, ft, sg)
    integer, intent(in) :: n, fixed
    real(q), intent(in) :: rx(2), ry, bn(2), bt
    integer, intent(out) :: nsol, sg
    real(q), intent(out) :: f(2), ft
    real(q) :: a(2,2), b(2), c, ae(2,2), be(2), p(2), w(2), pt, wt, tol, det, slip
    integer :: i, set, dir
    nsol = 0; f = 0; ft = 0; sg = 0
    do i = 1, n
      a(i,1:n) = 1 + rx(i)*rx(1:n)/rho2
    end do
    b = -rx*ry/rho2; c = 1 + ry*ry/rho2
    tol = 1.0e-30_q*(maxval(abs(bn(1:n))) + abs(bt))
    do dir = 0, 2                                 ! stick, slide +, slide -
      slip = real(merge(-1, dir, dir == 2), q)
      if (fixed /= 0 .and. nint(slip) /= fixed) cycle
      do i = 1, n                                 ! eliminate ft
        be(i) = bn(i) - merge(b(i)*bt/c, 0.0_q, dir == 0)
        ae(i,1:n) = a(i,1:n) - b(i)*merge(b(1:n)/c, spread(mu*slip, 1, n), dir == 0)
      end do
      do set = 0, 2**n - 1
        p = 0
        if (set == 1 .or. set == 2) then
          if (ae(set,set) == 0) cycle
          p(set) = -be(set)/ae(set,set)
        else if (set == 3) then
          det = ae(1,1)*ae(2,2) - ae(1,2)*ae(2,1)
          if (det == 0) cycle
          p = [be(2)*ae(1,2) - be(1)*ae(2,2), be(1)*ae(2,1) - be(2)*ae(1,1)]/det
        end if
        w(1:n) = be(1:n) + matmul(ae(1:n,1:n), p(1:n))
        if (any(p < -tol) .or. any(w(1:n) < -4*tol)) cycle
        if (dir == 0) then
          pt = -(bt + sum(b(1:n)*p(1:n)))/c
          if (abs(pt) > mu*sum(p) + tol) cycle
        else
          pt = -mu*slip*sum(p)
          wt = bt + sum(b(1:n)*p(1:n)) + c*pt
          if (fixed == 0 .and. slip*wt < -tol) cycle
        end if
        p = max(p, 0.0_q)
        if (nsol > 0) then                        ! boundary cases appear twice
          if (maxval(abs(p - f)) + abs(pt - ft) <= 1.0e5_q*tol) cycle
        end if
        nsol = nsol + 1; f = p; ft = pt; sg = nint(slip)
      end do
    end do
  end subroutine

  ! ------------------------------------------------------------------ impacts and onset of contact
  subroutine resolve()
    integer :: ids(2), n, i, nr, nsol, sg, rest
    real(q) :: rx(2), ry(2), vn(2), u, bn(2), e, f(2), ft, vt, bt
    n = merge(2, 1, tr == 0); ids = [merge(0, 1, tr >= 0), 1]
    do i = 1, n
      rx(i) = real(offset(ids(i))); ry(i) = aimag(offset(ids(i))); vn(i) = vy + om*rx(i)
    end do
    vt = noise*speed_scale()
    u = vx - om*ry(1)
    if (any(vn(1:n) < -vt)) then
      impacts = impacts + 1
      do i = 1, n
        if (abs(vn(i)) <= vt) vn(i) = 0
        e = eps
        if (eps < 1 .and. eps*abs(vn(i)) < cut) e = 0      ! ends the Zeno sequence
        bn(i) = vn(i) + e*min(vn(i), 0.0_q)
      end do
      call lcp(n, rx, ry(1), bn, u, 0, nsol, f, ft, sg)
      if (nsol /= 1) call refuse(merge('nosolution', 'ambiguous ', nsol == 0))
      if (reason /= '') return
      vx = vx + ft; vy = vy + sum(f(1:n)); om = om + (sum(rx(1:n)*f(1:n)) - ry(1)*ft)/rho2
      u = vx - om*ry(1)
      do i = 1, n
        vn(i) = vy + om*rx(i)
      end do
      if (any(vn(1:n) < -1.0e3_q*vt)) call refuse('impact')
      ! rocking from corner to corner is a Zeno sequence of its own, even for epsilon = 0
      if (n == 2 .and. eps < 1 .and. all(abs(vn(1:n)) < cut)) vn = 0
    end if
    nr = count(abs(vn(1:n)) <= vt); rest = merge(1, n, abs(vn(1)) <= vt)
    mode = flight
    if (nr == 0) return
    if (abs(u) <= vt) u = 0
    if (nr == 2) then
      om = 0; vy = 0; vx = u; bn = gy; bt = gx
    else
      rx(1) = rx(rest); ry(1) = ry(rest)
      vy = -om*rx(1); vx = u + om*ry(1)
      bn = gy - om**2*ry(1); bt = gx - om**2*rx(1)
    end if
    sg = 0
    if (u /= 0) sg = nint(sign(1.0_q, u))
    if (mu == 0) sg = 1                           ! direction is irrelevant without friction
    call lcp(nr, rx, ry(1), bn, bt, sg, nsol, f, ft, sig)
    if (nsol /= 1) call refuse('painleve')
    if (any(f > 0)) mode = corner
    if (nr == 1) then
      touching = ids(rest)
    else
      if (all(f > 0)) mode = side
      touching = merge(0, 1, f(1) > 0)
    end if
  end subroutine

  ! ------------------------------------------------------------------ the three kinds of motion
  subroutine fly()
    type(curve) :: cv
    real(q) :: s, best, low, h(0:3), grow
    integer :: j, jj, hit, n
    logical :: found
    cv%is_poly = .false.; cv%v = vy; cv%g = gy; cv%w = om; cv%third = l*sqrt(0.5_q)*abs(om)**3
    cv%vtiny = noise*speed_scale(); cv%atiny = 1.0e-26_q*(g_abs + l*om**2)
    low = max(y - 0.5_q*l*(cos(tr) + abs(sin(tr))), 0.0_q)
    if (grounded) low = 0
    h(0) = low + max(0.0_q, -l*sin(tr)); h(1) = low + max(0.0_q, l*sin(tr))
    h(2) = h(1) + l*cos(tr); h(3) = h(0) + l*cos(tr)
    best = until - t; hit = -1
    do jj = 0, 3
      j = merge(1 - jj, jj, tr < 0 .and. jj < 2)  ! lowest first, it shortens the search of the others
      cv%h0 = h(j); cv%rx = real(offset(j)); cv%ry = aimag(offset(j))
      grow = best*(abs(vy) + 0.5_q*abs(gy)*best + l*abs(om))
      if (h(j) > grow) cycle                      ! cannot arrive in time
      call first_root(cv, best, s, found)
      if (reason /= '') return
      hit = merge(j, hit, found); best = merge(s, best, found)
    end do
    x = x + (vx + 0.5_q*gx*best)*best; y = y + (vy + 0.5_q*gy*best)*best
    vx = vx + gx*best; vy = vy + gy*best; tr = tr + om*best; t = t + best
    n = normalise()
    grounded = hit >= 0
    if (grounded) then
      low = y
      call settle_on_ground()                     ! and two checks of the program itself
      if (abs(y - low) > (1.0e-26_q + 2*flat_tol)*(l + best*speed_scale())) call refuse('internal')
      if (abs(tr) > 1.0e-25_q .and. modulo(hit + n, 4) /= merge(0, 1, tr > 0)) call refuse('internal')
      call resolve()
    else
      t = until
    end if
  end subroutine

  subroutine settle_on_ground()                   ! a corner has height 0; is the square flat?
    if (abs(sin(tr)) <= flat_tol) tr = 0
    y = 0.5_q*l*(cos(tr) + abs(sin(tr)))
  end subroutine

  subroutine slide_on_side()
    real(q) :: a, time
    a = merge(0.0_q, gx + mu*sig*gy, sig == 0)    ! normal force is -gy
    time = until - t
    if (mu > 0 .and. a*sig < 0) time = min(time, -vx/a)
    x = x + (vx + 0.5_q*a*time)*time
    if (time < until - t) then
      vx = 0; t = t + time
      call resolve()
    else
      vx = vx + a*time; t = until
    end if
  end subroutine

  ! One Taylor step of contact of the corner `touching`; unknowns: tangential speed u and place s of
  ! the corner, tr, om.  Event functions are polynomials over the step.
  subroutine roll()
    real(q), dimension(0:nmax) :: tx, ty, th, w, u, s, ww, wx, wy, an, at, xx, xy, dd, fn, ft, ac, ut
    real(q) :: h, rem, best, root, vs, fs, sc
    type(curve) :: cv
    integer :: k, n, ev, hit
    logical :: found
    n = order; rem = until - t
    u(0) = 0; ut = 0                              ! stay 0 when sticking
    tx(0) = real(offset(touching)); ty(0) = aimag(offset(touching)); th(0) = tr; w(0) = om
    vs = speed_scale(); fs = g_abs + l*om**2
    s(0) = x + tx(0)
    if (sig /= 0) u(0) = vx - om*ty(0)
    if (abs(u(0)) <= noise*vs) u(0) = 0
    do k = 0, n - 1
      wx(k) = conv(w, tx, k); wy(k) = conv(w, ty, k); ww(k) = conv(w, w, k)
      xx(k) = conv(tx, tx, k)/rho2; xy(k) = conv(tx, ty, k)/rho2
      an(k) = -conv(ww, ty, k); at(k) = -conv(ww, tx, k)
      if (k == 0) an(0) = an(0) + gy
      if (k == 0) at(0) = at(0) + gx
      if (sig == 0) then
        ! a = 1 + xx, b = -xy, c = 4 - xx (corner at distance sqrt(3 rho2)), a c - b b = 4
        fn(k) = -(4*an(k) - conv(xx, an, k) + conv(xy, at, k))/4
        ft(k) = -(at(k) + conv(xx, at, k) + conv(xy, an, k))/4
      else
        dd(k) = xx(k) + mu*sig*xy(k)
        if (k == 0) dd(0) = dd(0) + 1
        if (dd(0) <= 0) call refuse('painleve')
        if (reason /= '') return
        fn(k) = -(an(k) + dot_product(fn(0:k-1), dd(k:1:-1)))/dd(0)
        ft(k) = -mu*sig*fn(k)
        ut(k) = at(k) - conv(xy, fn, k) + 4*ft(k) - conv(xx, ft, k)
      end if
      ac(k) = (conv(tx, fn, k) - conv(ty, ft, k))/rho2
      tx(k + 1) = -wy(k)/(k + 1); ty(k + 1) = wx(k)/(k + 1)
      th(k + 1) = w(k)/(k + 1); w(k + 1) = ac(k)/(k + 1)
      u(k + 1) = ut(k)/(k + 1); s(k + 1) = u(k)/(k + 1)
    end do
    h = rem
    if (abs(om) > 0) h = min(h, 0.7_q/abs(om))
    do k = n - 1, n
      sc = max(abs(th(k)), abs(tx(k))/l, abs(w(k))*l/vs, abs(u(k))/vs)
      if (sc > 0) h = min(h, (taylor_tol/sc)**(1.0_q/k))
    end do
    ! the force grows without bound
    if (h < 1.0e-10_q*rem .and. h*vs < 1.0e-10_q*l) call refuse('painleve')
    best = h; hit = 0
    do ev = 1, 6
      if ((ev == 1 .and. (sig == 0 .or. mu == 0)) .or. ((ev == 3 .or. ev == 4) .and. sig /= 0)) cycle
      select case (ev)
      case (1); call set_poly(sig*u(0:n), vs)                     ! sliding ends
      case (2); call set_poly(fn(0:n-1), fs)                      ! lift-off
      case (3, 4); call set_poly(mu*fn(0:n-1) + (2*ev - 7)*ft(0:n-1), fs)   ! sticking ends
      case (5); call set_poly([l*merge(sin(tr), cos(tr), touching == 0), tx(1:n) - ty(1:n)], l)
      case (6); call set_poly([l*merge(cos(tr), -sin(tr), touching == 0), -tx(1:n) - ty(1:n)], l)
      end select                                  ! 5, 6: the corner after, before this one comes down
      call first_root(cv, best, root, found)
      if (reason /= '') return
      hit = merge(ev, hit, found); best = merge(root, best, found)
    end do
    h = best
    tr = horner(th, n, h); om = horner(w, n, h)
    k = normalise()
    touching = modulo(touching + k, 4)
    if (hit >= 5) then
      call settle_on_ground()
      if (abs(tr) > 1.0e-27_q) call refuse('internal')
      tr = 0; call settle_on_ground()
      touching = merge(0, 1, hit == 5)            ! the old one, seen in the new face
    end if
    x = horner(s, n, h) - real(offset(touching))
    vx = om*aimag(offset(touching))
    if (sig /= 0 .and. hit /= 1) vx = vx + horner(u, n, h)
    vy = -om*real(offset(touching)); y = -aimag(offset(touching))
    t = t + h
    if (hit == 0 .and. h >= rem) t = until
    select case (hit)
    case (1, 5, 6); call resolve()
    case (2); mode = flight
    case (3, 4); sig = merge(-1, 1, horner(ft, n - 1, h) > 0)   ! slide against the force
    end select
  contains
    pure real(q) function conv(p, r, m)
      real(q), intent(in) :: p(0:nmax), r(0:nmax)
      integer, intent(in) :: m
      conv = dot_product(p(0:m), r(m:0:-1))
    end function
    pure real(q) function horner(p, m, z)
      real(q), intent(in) :: p(0:nmax), z
      integer, intent(in) :: m
      integer :: ii
      horner = p(m)
      do ii = m - 1, 0, -1
        horner = horner*z + p(ii)
      end do
    end function
    subroutine set_poly(c, scale)
      real(q), intent(in) :: c(0:), scale
      integer :: ii
      cv%n = ubound(c, 1); cv%c(0:cv%n) = c; cv%third = 0
      do ii = cv%n, 3, -1
        cv%third = cv%third*h + ii*(ii - 1)*(ii - 2)*abs(c(ii))
      end do
      do ii = 0, cv%n                             ! leading coefficients that are rounding only
        if (abs(c(ii))*h**ii > 1.0e-29_q*scale) exit
        cv%c(ii) = 0
      end do
    end subroutine
  end subroutine

  ! ------------------------------------------------------------------ one scene
  subroutine simulate(theta)
    real(q), intent(in) :: theta
    real(q) :: low
    real(d8) :: cpu0, cpu
    integer :: n, phases
    reason = ''; t = 0; impacts = 0; quarter = 0; touching = 0; mode = flight; sig = 0; grounded = .false.
    if (.not. (l > 0 .and. mu >= 0 .and. eps >= 0 .and. eps <= 1 .and. until >= 0)) call refuse('input')
    if (reason /= '') return
    rho2 = l**2/6; g_abs = sqrt(gx**2 + gy**2)
    cut = cut_factor*sqrt(g_abs*l)
    if (g_abs == 0) cut = cut_factor*(abs(vx) + abs(vy) + l*abs(om))  ! no other scale without gravity
    tr = theta; n = normalise()
    if (abs(sin(tr)) <= 1.0e-25_q) tr = 0
    low = y - 0.5_q*l*(cos(tr) + abs(sin(tr)))
    if (low < -1.0e-13_q*l) call refuse('below')
    call cpu_time(cpu0)
    if (low <= 1.0e-25_q*l .and. until > 0 .and. reason == '') then
      grounded = .true.; y = y - low
      call resolve()
    end if
    phases = 0
    do while (t < until .and. reason == '')
      phases = phases + 1
      call cpu_time(cpu)
      if (impacts > 200000 .or. phases > 1000000 .or. cpu - cpu0 > 5) call refuse('many')
      select case (mode)
      case (flight); call fly()
      case (corner); call roll()
      case (side); call slide_on_side()
      end select
    end do
  end subroutine
end module

program second_truth
  use world
  implicit none
  real(q) :: theta, opt(4)
  character(2000) :: line
  integer :: ios
  opt = [real(order, q), taylor_tol, flat_tol, cut_factor]
  do ios = 1, min(4, command_argument_count())
    call get_command_argument(ios, line); read (line, *) opt(ios)
  end do
  order = min(nint(opt(1)), nmax); taylor_tol = opt(2); flat_tol = opt(3); cut_factor = opt(4)
  do
    read (*, '(a)', iostat=ios) line
    if (ios /= 0) exit
    if (line == '') cycle
    read (line, *, iostat=ios) l, mu, eps, gx, gy, x, y, theta, vx, vy, om, until
    if (ios /= 0) l = -1                          ! refused as input
    call simulate(theta)
    if (reason /= '') then
      print '(a)', 'refused '//trim(reason)
    else
      print '(6(es40.29e3,1x))', x, y, quarter*(0.5_q*pi) + tr, vx, vy, om
    end if
  end do
end program
