namespace FootballPhysics.Tool.Replay.Gltf;

/// <summary>A triangle mesh, counter-clockwise seen from outside, with a normal at each corner.</summary>
internal sealed class Mesh
{
    /// <summary>The number of sides of round shapes.</summary>
    private const int Sides = 16;

    /// <summary>The number of rings of a hemisphere.</summary>
    private const int Rings = 5;

    private static readonly double s_golden = (1 + Math.Sqrt(5)) / 2;

    /// <summary>The twelve corners of the icosahedron from which the panels of a ball are cut. Its edges have the length 2.</summary>
    public static Vector3d[] Icosahedron { get; } =
        [.. new[] { -1.0, 1.0 }.SelectMany(a => new[] { -s_golden, s_golden }.SelectMany(b => new[] { new Vector3d(0, a, b), new Vector3d(a, b, 0), new Vector3d(b, 0, a) }))];

    public List<Vector3d> Positions { get; } = [];

    public List<Vector3d> Normals { get; } = [];

    public List<int> Indices { get; } = [];

    /// <summary>Returns a mesh of flat polygons.</summary>
    public static Mesh Of(IReadOnlyList<Vector3d[]> faces)
    {
        var mesh = new Mesh();
        foreach (Vector3d[] face in faces)
        {
            Vector3d normal = Vector3d.Cross(face[1] - face[0], face[2] - face[1]).Normalized();
            int first = mesh.Positions.Count;
            foreach (Vector3d corner in face)
            {
                mesh.Add(corner, normal);
            }

            for (int i = 2; i < face.Length; i++)
            {
                mesh.Indices.AddRange([first, first + i - 1, first + i]);
            }
        }

        return mesh;
    }

    /// <summary>Returns a capsule; a sphere if both ends are equal.</summary>
    public static Mesh Rod(Vector3d from, Vector3d to, double radius)
    {
        var mesh = new Mesh();
        Vector3d axis = (to - from).Length > 0 ? (to - from).Normalized() : Vector3d.Up;
        Vector3d u = Vector3d.Cross(axis, Math.Abs(axis.Y) < 0.9 ? Vector3d.Up : new Vector3d(1, 0, 0)).Normalized();
        Vector3d v = Vector3d.Cross(axis, u);
        for (int ring = 0; ring <= (2 * Rings) + 1; ring++)
        {
            // There are two rings at the equator, one around each end.
            bool below = ring <= Rings;
            double angle = ((below ? ring : ring - 1) - Rings) * (Math.PI / 2) / Rings;
            for (int side = 0; side < Sides; side++)
            {
                double around = 2 * Math.PI * side / Sides;
                Vector3d normal = (Math.Cos(angle) * ((Math.Cos(around) * u) + (Math.Sin(around) * v))) + (Math.Sin(angle) * axis);
                mesh.Add((below ? from : to) + (radius * normal), normal);
            }
        }

        for (int ring = 0; ring <= 2 * Rings; ring++)
        {
            for (int side = 0; side < Sides; side++)
            {
                int a = (ring * Sides) + side;
                int b = (ring * Sides) + ((side + 1) % Sides);
                mesh.Indices.AddRange([a, b, b + Sides, a, b + Sides, a + Sides]);
            }
        }

        return mesh;
    }

    /// <summary>Returns a mesh of the ground.</summary>
    public static Mesh Of(GroundGrid ground)
    {
        var mesh = new Mesh();
        for (int row = 0; row < ground.Rows; row++)
        {
            for (int column = 0; column < ground.Columns; column++)
            {
                Vector3d across = ground.At(Math.Min(column + 1, ground.Columns - 1), row) - ground.At(Math.Max(column - 1, 0), row);
                Vector3d down = ground.At(column, Math.Min(row + 1, ground.Rows - 1)) - ground.At(column, Math.Max(row - 1, 0));
                mesh.Add(ground.At(column, row), Vector3d.Cross(down, across).Normalized());
            }
        }

        for (int row = 0; row + 1 < ground.Rows; row++)
        {
            for (int column = 0; column + 1 < ground.Columns; column++)
            {
                int a = (row * ground.Columns) + column;
                mesh.Indices.AddRange([a, a + ground.Columns, a + ground.Columns + 1, a, a + ground.Columns + 1, a + 1]);
            }
        }

        return mesh;
    }

    /// <summary>Returns the panels of a ball of radius 1: the twelve pentagons of a truncated icosahedron, or its twenty hexagons.</summary>
    public static Mesh Panels(bool pentagons)
    {
        Vector3d[] corners = Icosahedron;
        bool Near(Vector3d a, Vector3d b) => Math.Abs((a - b).Length - 2) < 1e-9;
        Vector3d Cut(Vector3d from, Vector3d to) => (2 * from) + to;
        IEnumerable<Vector3d[]> panels = pentagons
            ? corners.Select(c => corners.Where(n => Near(c, n)).Select(n => Cut(c, n)).ToArray())
            : from a in corners
              from b in corners
              where Near(a, b) && Before(a, b)
              from c in corners
              where Near(a, c) && Near(b, c) && Before(b, c)
              select (Vector3d[])[Cut(a, b), Cut(b, a), Cut(b, c), Cut(c, b), Cut(c, a), Cut(a, c)];
        var mesh = new Mesh();
        foreach (Vector3d[] panel in panels)
        {
            mesh.AddPanel(panel);
        }

        return mesh;

        bool Before(Vector3d a, Vector3d b) => Array.IndexOf(corners, a) < Array.IndexOf(corners, b);
    }

    private void Add(Vector3d position, Vector3d normal)
    {
        Positions.Add(position);
        Normals.Add(normal);
    }

    /// <summary>Adds a panel of the ball from its corners, in order around its centre. Each triangle of the fan is divided into four, on the sphere.</summary>
    private void AddPanel(Vector3d[] panel)
    {
        Vector3d middle = panel.Aggregate((a, b) => a + b).Normalized();
        Vector3d u = (panel[0] - (Vector3d.Dot(panel[0], middle) * middle)).Normalized();
        Vector3d v = Vector3d.Cross(middle, u);
        Vector3d[] around = [.. panel.OrderBy(p => Math.Atan2(Vector3d.Dot(p, v), Vector3d.Dot(p, u))).Select(p => p.Normalized())];
        for (int i = 0; i < around.Length; i++)
        {
            Vector3d a = around[i];
            Vector3d b = around[(i + 1) % around.Length];
            (Vector3d ab, Vector3d bm, Vector3d ma) = ((a + b).Normalized(), (b + middle).Normalized(), (middle + a).Normalized());
            foreach (Vector3d[] triangle in (Vector3d[][])[[a, ab, ma], [ab, b, bm], [ma, bm, middle], [ab, bm, ma]])
            {
                foreach (Vector3d corner in triangle)
                {
                    Indices.Add(Positions.Count);
                    Add(corner, corner);
                }
            }
        }
    }
}
