# The durable memory: what can be wrong with it, who may change it, and what the command line shows of it.

FC-1201 = Kontrolün belleği hasarlı
    .detail = { $detail }. En yeni sağlam durum { $time } tarihli { $commits } numaralı kayıttır; geri getirmek için: { $command }
    .help = Hiçbir şey değiştirilmedi. "ferrocut memory check" bulunanları ve eldeki sağlam durumları gösterir; "ferrocut memory recover" en yenisini geri getirir ve hasarlı dosyaları saklar. Dosyalara hasar veren diski değiştirin.
FC-1202 = Belleği başka bir süreç açık tutuyor
    .help = Önce çalışan kontrolü kapatın ya da kapanmasını bekleyin.
FC-1203 = Belleği daha yeni bir sürüm yazmış
    .help = O sürümü kullanın ya da onun bu sürüm için aldığı bir yedeği geri yükleyin.
FC-1204 = Bellek başka bir kontrolün
    .detail = { $name }
    .help = Kontrolün kendi belleğinin klasörünü ya da belleğin ait olduğu kontrolü belirtin.
FC-1205 = Disk, kontrolün belleğini kabul etmiyor
    .detail = { $reason }
    .help = Disk dolu mu, salt okunur mu, bozuk mu, bakın. Daha önce onaylananlar yerindedir.
FC-1206 = Bellek bir değeri kabul etmiyor
    .detail = { $name } = { $value }: { $min } ile { $max } arası
    .detail-2 = { $name } = { $value }: en az { $min }
    .detail-3 = { $name } = { $value }: en çok { $max }
    .detail-4 = { $whole } = { $value }: yalnızca tam sayılar
    .detail-5 = { $unknown }: kontrolde böyle bir parametre yok
    .detail-6 = { $name } = { $value }
    .help = Kontrolün listesindeki aralıkta bir değer verin; hiçbir şey değiştirilmedi.
FC-1207 = Bellekte bu türden daha fazlasına yer yok
    .help = Artık gerekmeyenleri silin. 16 MB'tan büyük programları dosyalarda tutun.
FC-1208 = Klasörde bir kontrolün belleği yok
    .detail = { $file }
    .help = memory.db dosyasının bulunduğu klasörü belirtin, bir dosyayı değil. "ferrocut memory restore" bir yedekten klasör yapar.
FC-1209 = Dosya bu sürümün okuduğu bir yedek değil
    .detail = { $file }, sürüm { $version }
    .detail-2 = { $file }
    .help = "ferrocut memory backup" ya da kontrolün oluşturduğu bir dosya verin. Daha yeni bir sürümün yedeği o sürümü gerektirir.
FC-1210 = Yedek hasarlı
    .detail = { $file }, satır { $line }
    .detail-2 = satır { $line }
    .help = Hiçbir şey geri yüklenmedi. Dosyayı alındığı yerden yeniden kopyalayın ya da başka bir yedek kullanın.
FC-1211 = Yedek başka bir kontrolün
    .detail = { $name }
    .help = Öyle bir kontrolün belleğine geri yükleyin; başka bir kontrolün parametre ve tabloları başka anlamlar taşır.
FC-1212 = Geri yüklenecek olan yedekte yok
    .help = İçindekileri "ferrocut memory check" gösterir.
FC-1213 = Daha yüksek bir yetki düzeyi gerekir
    .detail = düzey { $needed }, şimdiki düzey { $level }
    .help = O düzeyle oturum açın ya da parolası olan birine yaptırın.
FC-1214 = Bir parametre değişikliği yasaklıyor
    .detail = { $parameter }
    .help = Parametreyi değiştirme yetkisi olan kişi yasağı kaldırabilir.
FC-1215 = Programı daha yüksek bir düzey kilitlemiş
    .detail = düzey { $level }
    .help = Kilidi o düzeye açtırın.
FC-1216 = Bunu bir parça programı değiştiremez
    .help = Panelden değiştirin.
FC-1217 = Düzeyin henüz parolası yok ve yetkileri kimsede değil
    .detail = düzey { $level }
    .help = Tezgâhta 1. düzeyin parolasını, sonra öbür düzeylerinkini belirleyin. O zamana kadar kimse oturum açamaz.
FC-1218 = Parola yanlış
    .help = Yeniden deneyin; üç yanlış paroladan sonra yeni deneme için beklemek gerekir.
FC-1219 = Parola çok kısa ya da çok uzun
    .help = En az 8 karakter kullanın, örneğin üç sözcük.
FC-1220 = Çok fazla yanlış parola
    .detail = { $time } s bekleyin
    .help = Bu süreden sonra yeniden deneyin.
FC-1221 = Kontrol çalışırken konum geri yüklenmez
    .help = Kontrol eksenlerinin nerede durduğunu bilir; başka bir ana ait konum yanlış olur. Kontrolü kapatın ve bu öğe için "ferrocut memory restore" kullanın.

label-finding-missing = memory.db yok
label-finding-structure = memory.db yapısı: { $said }
label-finding-schema = tablolar bu belleğinkiler değil
label-finding-row = { $table } tablosunun bir satırı beklenmedik biçimde değişmiş
label-finding-total = { $table } tablosunun satırları kaybolmuş ya da geri gelmiş
label-finding-commits = { $found } yazma işlemi var, { $reported } tanesi onaylanmıştı
label-finding-mark = onaylanan yazma işlemlerini sayan "mark" dosyası okunamıyor
label-memory-folder = bellek
label-memory-control = kontrol
label-memory-commits = yazma işlemleri
label-memory-whole = { $file }: sağlam, { $commits } yazma işlemi
label-memory-backup-whole = { $file }: sağlam, { $control } yedeği, { $time }
label-memory-rows = satırlar
label-memory-damaged = { $file }: hasarlı
label-memory-good-states = sağlam durumlar, en yenisi başta:
label-memory-no-good-state = sağlam durum kalmadı: bir yedeği yeni bir klasöre geri yükleyin
label-memory-in-database = veritabanının kendisi
label-memory-lost = { $count ->
    [one] onaylanmış 1 yazma işlemi eksik
   *[other] onaylanmış { $count } yazma işlemi eksik
}
label-memory-recovered = geri getirildi: yazma işlemi { $commits }, { $time }; hasarlı dosyalar { $file } içinde
label-memory-no-such-state = yazma işlemi { $commits } için sağlam bir durum yok
label-memory-restored = { $folder } klasörüne geri yüklendi: { $items }
label-memory-passwords = parolası olan düzeyler
label-memory-none = yok
label-memory-password-set = { $level }. düzeyin parolası ayarlandı
label-memory-empty = saklanan bir şey yok
label-item-programs = parça programları
label-item-parameters = fabrika değerinden farklı parametreler
label-item-offsets = aşınmalarıyla takım ofsetleri
label-item-zeros = iş sıfırları
label-item-reference-points = referans noktaları
label-item-variables = makro değişkenleri
label-item-pitch = hatve hatası tablolarının noktaları
label-item-plc = merdiven programının saklanan sinyalleri, 64 baytlık bloklar
label-item-counters = sayaçlar
label-item-alarms = alarm geçmişi
label-item-log = işlem kaydı
label-item-position = güç kesildiğindeki konum
label-item-interrupted = yarıda kalan program
label-item-ladder = tezgâhın kendi merdiven programı yerine çalışan
