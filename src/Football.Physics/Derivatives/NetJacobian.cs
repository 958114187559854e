namespace Football.Physics;

/// <summary>How the push of the nets that a ball is in changes with its motion.</summary>
internal readonly struct NetJacobian
{
    private readonly World _world;
    private readonly ulong _nets;
    private readonly ulong _sides;

    public NetJacobian(World world, ulong nets, ulong sides)
    {
        _world = world;
        _nets = nets;
        _sides = sides;
    }

    /// <summary>
    /// Adds how the push of the nets changes with the motion. It is linear in the place, and in the velocity on either side of where a net becomes slack: so
    /// each is changed to that side of it on which it is.
    /// </summary>
    /// <param name="at">The motion.</param>
    /// <param name="soon">The motion a moment later, or itself: it says on which side of a kink it is where it is on one.</param>
    /// <param name="a">A.</param>
    public void Add(in Motion at, in Motion soon, double[] a)
    {
        for (int net = 0; net < _world.Nets.Length; net++)
        {
            NetSheet sheet = _world.Nets[net];
            double side = World.SideOf(_sides, net);
            if ((_nets >> net & 1) == 0 || !(sheet.Depth(in soon.Position, side) > 0))
            {
                continue;
            }

            bool tight = sheet.Tension(in soon.Velocity, side) > 0;
            MotionRates here = sheet.Push(in at, side);
            for (int i = 0; i < MotionVector.AirDistance; i++)
            {
                // Deeper, and tighter where it is tight: both go with −σ n.
                double along = side * MotionVector.Component(sheet.Normal, i % 3);
                bool up = i >= MotionVector.Velocity && i < MotionVector.Spin && !tight ? along > 0 : along < 0;
                double width = up ? MotionVector.Width(in at, i) : -MotionVector.Width(in at, i);
                MotionRates there = sheet.Push(MotionVector.Changed(in at, i, width), side);
                MotionVector.Add(a, MotionVector.Velocity, i, (1.0 / width) * (there.Acceleration - here.Acceleration));
                MotionVector.Add(a, MotionVector.Spin, i, (1.0 / width) * (there.SpinAcceleration - here.SpinAcceleration));
            }
        }
    }

    /// <summary>How far a motion is from the nearest kink of the nets' push: by its depth, m, and by its speed, m/s.</summary>
    public void Margins(in Motion at, out double depth, out double speed)
    {
        depth = double.PositiveInfinity;
        speed = double.PositiveInfinity;
        for (int net = 0; net < _world.Nets.Length; net++)
        {
            if ((_nets >> net & 1) != 0)
            {
                NetSheet sheet = _world.Nets[net];
                double side = World.SideOf(_sides, net);
                depth = Math.Min(depth, Math.Abs(sheet.Depth(in at.Position, side)));
                speed = Math.Min(speed, Math.Abs(sheet.Tension(in at.Velocity, side)) * sheet.ReturnSpeed);
            }
        }
    }
}
