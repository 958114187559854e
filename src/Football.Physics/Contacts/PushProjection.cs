namespace FootballPhysics.Contacts;

/// <summary>The part of a push that frictionless contacts do not take up: at most two have a load, or three or more take it all.</summary>
internal unsafe struct PushProjection
{
    /// <summary>The contacts with a load; −1 for none.</summary>
    public int First;
    public int Second;

    /// <summary>Their loads, m/s².</summary>
    public double FirstLoad;
    public double SecondLoad;

    /// <summary>The remaining push, m/s².</summary>
    public Vector3d Left;

    /// <summary>True if three or more independent loads take up the entire push.</summary>
    public bool TakesAll;

    /// <summary>Projects a push onto the directions that the contacts leave free, m/s².</summary>
    /// <param name="normals">The normals of the contacts, towards the ball.</param>
    /// <param name="count">The number of contacts.</param>
    /// <param name="push">The push.</param>
    public static PushProjection Of(Vector3d* normals, int count, in Vector3d push)
    {
        var none = new PushProjection { First = -1, Second = -1, Left = push };
        if (IsLeft(normals, count, in push))
        {
            return none;
        }

        for (int i = 0; i < count; i++)
        {
            double load = -Vector3d.Dot(in push, in normals[i]);
            Vector3d left = push + (load * normals[i]);
            if (load >= 0 && IsLeft(normals, count, in left))
            {
                return new PushProjection { First = i, Second = -1, FirstLoad = load, Left = left };
            }
        }

        for (int i = 0; i < count; i++)
        {
            for (int j = i + 1; j < count; j++)
            {
                Vector3d n = normals[i];
                Vector3d m = normals[j];
                double cosine = Vector3d.Dot(in n, in m);
                double square = 1.0 - (cosine * cosine);
                double a = -Vector3d.Dot(in push, in n);
                double b = -Vector3d.Dot(in push, in m);
                double first = (a - (cosine * b)) / square;
                double second = (b - (cosine * a)) / square;
                Vector3d left = push + (first * n) + (second * m);
                if (square > ContactTolerances.Independent && first >= 0 && second >= 0 && IsLeft(normals, count, in left))
                {
                    return new PushProjection { First = i, Second = j, FirstLoad = first, SecondLoad = second, Left = left };
                }
            }
        }

        none.TakesAll = true;
        return none;
    }

    /// <summary>True if two of the normals are opposite, so that any load may act on both contacts.</summary>
    /// <remarks>The angle is within that of flush normals: as far as a ball that rolls off two opposite spheres still touches both.</remarks>
    public static bool Clamp(Vector3d* normals, int count)
    {
        for (int i = 0; i < count; i++)
        {
            for (int j = i + 1; j < count; j++)
            {
                if (Vector3d.Dot(in normals[i], in normals[j]) < ContactTolerances.SameNormal - 1.0)
                {
                    return true;
                }
            }
        }

        return false;
    }

    /// <summary>True if three normals lie in one plane and surround the ball, n₁ + β n₂ + γ n₃ = 0 with β, γ > 0.</summary>
    /// <remarks>Their loads are then not determined if all three are active, and a push needs at most two of them.</remarks>
    public static bool Surround(Vector3d* normals)
    {
        Vector3d third = Vector3d.Cross(in normals[0], in normals[1]);
        return Math.Abs(Vector3d.Dot(in normals[2], in third)) <= ContactTolerances.Independent
            && Vector3d.Dot(Vector3d.Cross(in normals[1], in normals[2]), in third) > 0 && Vector3d.Dot(Vector3d.Cross(in normals[2], in normals[0]), in third) > 0;
    }

    /// <summary>True if a contact has a load.</summary>
    public readonly bool Bears(int index) => TakesAll || index == First || index == Second;

    /// <summary>Returns the load of a contact, m/s²; zero if it has none, or if it is not determined.</summary>
    public readonly double LoadOf(int index) => index == First ? FirstLoad : index == Second ? SecondLoad : 0;

    /// <summary>True if a push does not press the ball against any contact.</summary>
    private static bool IsLeft(Vector3d* normals, int count, in Vector3d push)
    {
        for (int i = 0; i < count; i++)
        {
            if (Vector3d.Dot(in push, in normals[i]) < -ContactTolerances.LeastLoad)
            {
                return false;
            }
        }

        return true;
    }
}
