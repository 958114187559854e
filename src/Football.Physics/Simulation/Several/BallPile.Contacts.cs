using FootballPhysics.Contacts;

namespace FootballPhysics.Simulation;

/// <content>Contacts of the pile.</content>
internal sealed partial class BallPile
{
    /// <summary>Finds all contacts within reach.</summary>
    private void Find(BallState[] states, double reach, double h)
    {
        // Keep the contacts of the previous part, for the warm start.
        (_last, _system.Contacts) = (_system.Contacts, _last);
        _lastCount = _system.ContactCount;
        _system.ContactCount = 0;
        Span<Contact> room = stackalloc Contact[ContactSet.Room];
        for (int i = 0; i < Count; i++)
        {
            ref PileMember member = ref _system.Members[i];
            ref readonly BallState s = ref states[member.Ball];
            World world = _simulators[member.Ball].World;

            // A moving object also approaches the ball: widen the search by the object's path.
            double far = reach + (world.Moves ? h * world.FastestMover : 0);
            Span<Contact> near = ContactSet.Near(world, in s, far, room, world.Room);
            ref PressedBall ball = ref _system.Balls[i];
            ball.FirstContact = _system.ContactCount;
            ball.OwnContacts = near.Length;
            foreach (ref readonly Contact contact in near)
            {
                _system.Add(With(in contact, i, in s, h));
            }

            for (int j = i + 1; j < Count; j++)
            {
                Vector3d apart = s.Position - states[_system.Members[j].Ball].Position;
                double most = ball.Radius + _system.Balls[j].Radius + reach;
                if (Math.Abs(apart.Y) <= most && Math.Abs(apart.X) <= most && apart.LengthSquared <= most * most)
                {
                    _system.Add(Between(i, j, in apart));
                }
            }
        }
    }

    private Contact With(in Contact near, int index, in BallState s, double h)
    {
        Collider collider = _simulators[_system.Members[index].Ball].World.ByIndex[near.Collider];
        return near with
        {
            First = index,
            MovesNow = !BallRests.Bears(in near, collider),

            // On a rotating surface, use the velocity at the end of the part. With the velocity at the start, a gripping ball would slip by |Ω × v|
            // h.
            Velocity = collider.SurfaceVelocity(s.Position + (h * s.Velocity) - (_system.Balls[index].Radius * near.Normal), in near.Normal, s.Time + h),
            Gap = Math.Max(0, near.Gap),
        };
    }

    private Contact Between(int first, int second, in Vector3d apart)
    {
        ref readonly PressedBall a = ref _system.Balls[first];
        ref readonly PressedBall b = ref _system.Balls[second];
        double distance = apart.Length;
        double perMass = a.PerMass + b.PerMass;
        return new Contact
        {
            First = first,
            Second = second,
            Collider = -1,
            Normal = BallContact.Normal(in apart, distance),
            Gap = Math.Max(0, distance - a.Radius - b.Radius),
            NormalMass = 1.0 / perMass,
            SlipMass = 1.0 / (perMass + (a.Radius * a.Radius * a.PerInertia) + (b.Radius * b.Radius * b.PerInertia)),
            TwistMass = 1.0 / (a.PerInertia + b.PerInertia),
            Material = _material,
        };
    }

    /// <summary>Warm start: a contact that existed in the previous part starts with the impulses from that part.</summary>
    /// <param name="share">Scale factor of the impulses.</param>
    private bool Continue(double share)
    {
        int first = 0;
        for (int i = 0; i < _system.ContactCount && _lastCount > 0; i++)
        {
            // Both lists are ordered by the first ball, and each ball has few contacts: scan both in parallel.
            ref Contact contact = ref _system.Contacts[i];
            while (first < _lastCount && _last[first].First < contact.First)
            {
                first++;
            }

            for (int k = first; k < _lastCount && _last[k].First == contact.First; k++)
            {
                ref readonly Contact last = ref _last[k];
                if (last.Second == contact.Second && last.Collider == contact.Collider)
                {
                    contact.Load = share * last.Load;
                    contact.Twist = share * last.Twist;
                    contact.Rub = share * (last.Rub - (Vector3d.Dot(in last.Rub, in contact.Normal) * contact.Normal));
                    break;
                }
            }
        }

        return _lastCount > 0;
    }
}
