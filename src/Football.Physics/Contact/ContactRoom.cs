using System.Collections.Concurrent;

namespace FootballPhysics;

/// <summary>Memory for contact sets of more contacts than a caller has room for on its stack.</summary>
/// <remarks>
/// Stationary surfaces are never left out of a set, however many a ball touches. The memory is kept, so that a step with as many contacts
/// as one before it allocates nothing. Each set that is in use at the same time requires its own. Threads that share a simulator have a
/// memory each.
/// </remarks>
internal sealed class ContactRoom
{
    private readonly ConcurrentDictionary<int, Contact[]> _contacts = new();

    /// <summary>Room for a number of contacts.</summary>
    /// <param name="count">The number of contacts.</param>
    /// <param name="room">The room that the caller has.</param>
    /// <returns>The caller's room if it is large enough, or this memory.</returns>
    public Span<Contact> Of(int count, Span<Contact> room)
    {
        if (count <= room.Length)
        {
            return room;
        }

        int thread = Environment.CurrentManagedThreadId;
        if (!_contacts.TryGetValue(thread, out Contact[]? contacts) || contacts.Length < count)
        {
            contacts = new Contact[Math.Max(count, 2 * (contacts?.Length ?? 0))];
            _contacts[thread] = contacts;
        }

        return contacts;
    }

    /// <summary>Twice the room of a set that is full, with the same contacts.</summary>
    public Span<Contact> Grown(Span<Contact> full)
    {
        Span<Contact> grown = Of(2 * full.Length, default);
        full.CopyTo(grown);
        return grown;
    }
}
