using Microsoft.Xna.Framework.Graphics;

namespace Microsoft.Xna.Framework
{
    public readonly record struct Vector2(float X, float Y);

    public readonly record struct Vector3(float X, float Y, float Z)
    {
        public static Vector3 Up => new(0, 1, 0);
    }

    public readonly record struct Quaternion(float X, float Y, float Z, float W);

    public readonly record struct Color(byte R, byte G, byte B, byte A)
    {
        public Color(int r, int g, int b)
            : this((byte)r, (byte)g, (byte)b, 255)
        {
        }

        public static Color White => new(255, 255, 255);

        public static Color CornflowerBlue => new(100, 149, 237);

        public static Color ForestGreen => new(34, 139, 34);

        public Vector3 ToVector3() => new(R / 255f, G / 255f, B / 255f);
    }

    /// <summary>A matrix for row vectors, as that of .NET.</summary>
    public readonly record struct Matrix(System.Numerics.Matrix4x4 Value)
    {
        public static Matrix Identity => new(System.Numerics.Matrix4x4.Identity);

        public static Matrix operator *(Matrix a, Matrix b) => new(a.Value * b.Value);

        public static Matrix CreateTranslation(float x, float y, float z) => new(System.Numerics.Matrix4x4.CreateTranslation(x, y, z));

        public static Matrix CreateFromQuaternion(Quaternion q) => new(System.Numerics.Matrix4x4.CreateFromQuaternion(new System.Numerics.Quaternion(q.X, q.Y, q.Z, q.W)));

        public static Matrix CreateLookAt(Vector3 cameraPosition, Vector3 cameraTarget, Vector3 cameraUpVector) =>
            new(System.Numerics.Matrix4x4.CreateLookAt(Of(cameraPosition), Of(cameraTarget), Of(cameraUpVector)));

        public static Matrix CreatePerspectiveFieldOfView(float fieldOfView, float aspectRatio, float nearPlaneDistance, float farPlaneDistance) =>
            new(System.Numerics.Matrix4x4.CreatePerspectiveFieldOfView(fieldOfView, aspectRatio, nearPlaneDistance, farPlaneDistance));

        private static System.Numerics.Vector3 Of(Vector3 v) => new(v.X, v.Y, v.Z);
    }

    public static class MathHelper
    {
        public static float ToRadians(float degrees) => degrees * (MathF.PI / 180);
    }

    public sealed class GameTime
    {
        public TimeSpan ElapsedGameTime { get; init; }
    }

    public sealed class GameWindow
    {
        public string Title { get; set; } = "";
    }

    public sealed class GraphicsDeviceManager
    {
        public GraphicsDeviceManager(Game game) => game.GraphicsDevice = new GraphicsDevice();

        public bool PreferMultiSampling { get; set; }
    }

    /// <summary>A game without a screen: it runs for 2.5 seconds, space is down in frames 10 to 12, and the device records the draws.</summary>
    public class Game : IDisposable
    {
        private const int Frames = 150;

        /// <summary>The game that ran last.</summary>
        public static Game? Last { get; private set; }

        public GraphicsDevice GraphicsDevice { get; internal set; } = null!;

        public GameWindow Window { get; } = new();

        public void Run()
        {
            Last = this;
            _ = GraphicsDevice ?? throw new InvalidOperationException("The game has no GraphicsDeviceManager.");
            Initialize();
            var time = new GameTime { ElapsedGameTime = TimeSpan.FromSeconds(1.0 / 60) };
            for (int frame = 0; frame < Frames; frame++)
            {
                Input.Keyboard.IsSpaceDown = frame is >= 10 and < 13;
                Update(time);
                GraphicsDevice.Frames.Add([]);
                Draw(time);
            }
        }

        public void Dispose() => GC.SuppressFinalize(this);

        protected virtual void Initialize() => LoadContent();

        protected virtual void LoadContent()
        {
        }

        protected virtual void Update(GameTime gameTime)
        {
        }

        protected virtual void Draw(GameTime gameTime)
        {
        }
    }
}

namespace Microsoft.Xna.Framework.Input
{
    public enum Keys
    {
        Space = 32,
    }

    public readonly record struct KeyboardState(bool IsSpaceDown)
    {
        public bool IsKeyDown(Keys key) => key == Keys.Space && IsSpaceDown;
    }

    public static class Keyboard
    {
        internal static bool IsSpaceDown { get; set; }

        public static KeyboardState GetState() => new(IsSpaceDown);
    }
}

namespace Microsoft.Xna.Framework.Graphics
{
    public enum PrimitiveType
    {
        TriangleList,
    }

    public interface IVertexType
    {
    }

    public readonly record struct VertexPositionNormalTexture(Vector3 Position, Vector3 Normal, Vector2 TextureCoordinate) : IVertexType;

    public readonly record struct Viewport(int Width, int Height)
    {
        public float AspectRatio => (float)Width / Height;
    }

    public sealed class Texture2D(GraphicsDevice graphicsDevice, int width, int height)
    {
        public void SetData<T>(T[] data)
            where T : struct => _ = graphicsDevice != null && data.Length == width * height ? 0 : throw new ArgumentException("The data are not the texture's.", nameof(data));
    }

    public sealed class EffectPass(BasicEffect effect)
    {
        public void Apply() => effect.Device.Applied = effect;
    }

    public sealed class EffectTechnique(BasicEffect effect)
    {
        public IReadOnlyList<EffectPass> Passes { get; } = [new EffectPass(effect)];
    }

    public sealed class BasicEffect
    {
        public BasicEffect(GraphicsDevice device)
        {
            Device = device;
            CurrentTechnique = new EffectTechnique(this);
        }

        public Matrix World { get; set; } = Matrix.Identity;

        public Matrix View { get; set; } = Matrix.Identity;

        public Matrix Projection { get; set; } = Matrix.Identity;

        public Vector3 DiffuseColor { get; set; }

        public bool TextureEnabled { get; set; }

        public Texture2D? Texture { get; set; }

        public EffectTechnique CurrentTechnique { get; }

        internal GraphicsDevice Device { get; }

        internal bool IsLit { get; private set; }

        public void EnableDefaultLighting() => IsLit = true;
    }

    /// <summary>A mesh on the screen: the triangles that face the camera and the middle of their corners, −1 … 1, and if they have a texture.</summary>
    public readonly record struct DrawnMesh(int Triangles, System.Numerics.Vector3 Middle, bool IsTextured);

    public sealed class GraphicsDevice
    {
        /// <summary>The meshes of each frame.</summary>
        public List<List<DrawnMesh>> Frames { get; } = [];

        public Viewport Viewport { get; } = new(800, 480);

        internal BasicEffect? Applied { get; set; }

        public void Clear(Color color) => Applied = null;

        public void DrawUserIndexedPrimitives<T>(PrimitiveType primitiveType, T[] vertexData, int vertexOffset, int numVertices, short[] indexData, int indexOffset, int primitiveCount)
            where T : struct, IVertexType
        {
            BasicEffect effect = Applied is { IsLit: true } lit ? lit : throw new InvalidOperationException("No pass with lighting is applied.");
            if (effect.TextureEnabled && effect.Texture == null)
            {
                throw new InvalidOperationException("The effect has no texture.");
            }

            System.Numerics.Matrix4x4 all = (effect.World * effect.View * effect.Projection).Value;
            System.Numerics.Vector3[] seen = [.. vertexData.Cast<VertexPositionNormalTexture>().Skip(vertexOffset).Take(numVertices).Select(vertex => Seen(vertex.Position, all))];
            int triangles = 0;
            System.Numerics.Vector3 sum = default;
            for (int i = indexOffset; i < indexOffset + (3 * primitiveCount); i += 3)
            {
                System.Numerics.Vector3 corner = seen[indexData[i]];
                System.Numerics.Vector3 one = seen[indexData[i + 1]] - corner;
                System.Numerics.Vector3 other = seen[indexData[i + 2]] - corner;

                // The default culls counter-clockwise triangles; y is up here.
                if ((one.X * other.Y) - (one.Y * other.X) < 0)
                {
                    triangles++;
                    sum += corner + ((one + other) / 3);
                }
            }

            Frames[^1].Add(new DrawnMesh(triangles, sum / Math.Max(1, triangles), effect.TextureEnabled));
        }

        private static System.Numerics.Vector3 Seen(Vector3 p, System.Numerics.Matrix4x4 all)
        {
            var clip = System.Numerics.Vector4.Transform(new System.Numerics.Vector4(p.X, p.Y, p.Z, 1), all);
            return new System.Numerics.Vector3(clip.X, clip.Y, clip.Z) / clip.W;
        }
    }
}
